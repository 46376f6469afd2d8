#include "base/text_table.h"

#include "base/terminal.h"
#include "base/text.h"

#include <algorithm>
#include <functional>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs {

namespace {

constexpr std::size_t kGap = 2;  // between columns

std::vector<TableRow> cleaned(std::vector<TableRow> rows) {
  for (auto& row : rows)
    for (auto& cell : row) cell = clean_line(cell);
  return rows;
}

std::vector<std::size_t> column_widths(const std::vector<TableRow>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    if (row.size() > widths.size()) widths.resize(row.size(), 0);
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], display_width(row[i]));
  }
  return widths;
}

// Where a column stands: its line within the row, its first column on the terminal, and how wide its cells
// may be before they are broken: 0 for any width.
struct Place {
  std::size_t line = 0;
  std::size_t start = 0;
  std::size_t width = 0;
};

constexpr std::size_t kIndent = 6;  // of what goes on below

// Whether the last column's cells are broken where they stand. A column that would become too narrow starts
// below instead: whole sentences are readable in 30 columns, and short cells in three lines.
bool is_broken_in_place(std::size_t start,
                        std::size_t width,
                        std::size_t terminal,
                        std::size_t longest_word) {
  constexpr std::size_t kLeast = 30;
  constexpr std::size_t kLines = 3;
  const auto least = width > kLeast ? kLeast : std::max(longest_word, (width + kLines - 1) / kLines);
  return start + least <= terminal;
}

std::size_t longest_word_of_last(const std::vector<TableRow>& rows, std::size_t columns) {
  std::size_t longest = 0;
  for (const auto& row : rows)
    if (row.size() == columns && columns > 0)
      for (const auto& word : words_of(row.back())) longest = std::max(longest, display_width(word));
  return longest;
}

// Columns that have no room behind the ones before them start on another line of their row, so that no number
// is cut. The last column's cells are broken between words.
std::vector<Place> places_of(const std::vector<std::size_t>& widths,
                             std::size_t terminal,
                             std::size_t longest_word) {
  std::vector<Place> places;
  std::size_t line = 0;
  std::size_t start = 0;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const bool is_last = i + 1 == widths.size();
    const bool is_too_wide = terminal > 0 && start + widths[i] > terminal;
    if (is_too_wide && i > 0 && start > kIndent &&
        !(is_last && is_broken_in_place(start, widths[i], terminal, longest_word))) {
      ++line;
      start = kIndent;
    }
    places.push_back({line, start, 0});
    if (terminal > 0 && is_last && start + widths[i] > terminal)
      places.back().width = std::max(terminal, start + 1) - start;
    start += widths[i] + kGap;
  }
  return places;
}

std::string padded(const std::string& cell, std::size_t width, Align align) {
  if (align == Align::Left) return cell;
  auto text = cell;
  text.insert(0, width - display_width(cell), ' ');
  return text;
}

// Takes the blanks at the end away.
void end_line(std::string& text) { text.erase(text.find_last_not_of(' ') + 1); }

// A row that is built cell by cell.
struct RowText {
  std::string text;
  std::size_t line = 0;    // of the places of its columns
  std::size_t column = 0;  // where the next cell would start

  void add(const std::string& cell, const Place& place) {
    if (display_width(cell) == 0) return;
    if (place.line != line) {
      end_line(text);
      text += '\n';
      line = place.line;
      column = 0;
    }
    text.append(place.start - column, ' ');
    const auto parts = wrapped(cell, place.width);
    text += parts.front();
    for (std::size_t i = 1; i < parts.size(); ++i)
      text.append(1, '\n').append(place.start, ' ').append(parts[i]);
    column = place.start + display_width(parts.back());
  }
};

std::string row_text(const TableRow& row,
                     const std::vector<Place>& places,
                     const std::function<std::string(std::size_t)>& shown) {
  RowText out;
  for (std::size_t i = 0; i < row.size(); ++i) out.add(shown(i), places[i]);
  end_line(out.text);
  return out.text + '\n';
}

// The table of the first `kept` columns and of those of a range behind them.
std::string some_columns(const std::vector<TableRow>& rows,
                         std::size_t kept,
                         std::pair<std::size_t, std::size_t> range,
                         const TableLook& look) {
  TableLook look_of_these{look.width, {}};
  std::vector<TableRow> these;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    auto& row = these.emplace_back();
    for (std::size_t i = 0; i < std::min(range.second, rows[r].size()); ++i) {
      if (i >= kept && i < range.first) continue;
      if (const auto colour = look.colours.find({r, i}); colour != look.colours.end())
        look_of_these.colours[{r, row.size()}] = colour->second;
      row.push_back(rows[r][i]);
    }
  }
  return text_table(these, {}, look_of_these);
}

}  // namespace

std::size_t display_width(std::string_view text) {
  std::size_t width = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\x1b') {
      i = std::min(text.find('m', i), text.size());
    } else if ((static_cast<unsigned char>(text[i]) & 0xc0U) != 0x80U) {  // not a continuation byte
      ++width;
    }
  }
  return width;
}

std::vector<std::string> wrapped(std::string_view text, std::size_t width) {
  if (width == 0) return {std::string(text)};
  std::vector<std::string> lines{""};
  for (const auto& word : words_of(text)) {
    auto& line = lines.back();
    if (line.empty()) {
      line = word;
    } else if (display_width(line) + 1 + display_width(word) <= width) {
      line += ' ' + word;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

std::string text_table(const std::vector<TableRow>& rows,
                       const std::vector<Align>& columns,
                       const TableLook& look) {
  const auto clean = cleaned(rows);
  const auto widths = column_widths(clean);
  const auto places =
      places_of(widths, static_cast<std::size_t>(look.width), longest_word_of_last(clean, widths.size()));
  std::string text;
  for (std::size_t r = 0; r < clean.size(); ++r)
    text += row_text(clean[r], places, [&](std::size_t i) {
      const auto& cell = clean[r][i];
      const auto colour = look.colours.find({r, i});
      const auto align = i < columns.size() ? columns[i] : Align::Left;
      const auto whole = places[i].width > 0 || cell.empty() ? cell : padded(cell, widths[i], align);
      return colour == look.colours.end() || cell.empty() ? whole : painted(whole, colour->second, {true, 0});
    });
  return text;
}

bool fits(const std::vector<TableRow>& rows, int width) {
  std::size_t needed = 0;
  for (const auto column : column_widths(cleaned(rows))) needed += column + (needed == 0 ? 0 : kGap);
  return width == 0 || needed <= static_cast<std::size_t>(width);
}

std::string text_tables(const std::vector<TableRow>& rows, std::size_t kept, const TableLook& look) {
  const auto widths = column_widths(cleaned(rows));
  const auto terminal = static_cast<std::size_t>(look.width);
  std::size_t first = 0;  // columns that all tables have
  for (std::size_t i = 0; i < std::min(kept, widths.size()); ++i) first += widths[i] + kGap;
  std::string text;
  for (std::size_t from = kept; from < widths.size() || text.empty();) {
    auto end = from;
    for (std::size_t start = first; end < widths.size(); start += widths[end++] + kGap)
      if (terminal > 0 && end > from && start + widths[end] > terminal) break;
    if (!text.empty()) text += '\n';
    text += some_columns(rows, kept, {from, end}, look);
    from = std::max(end, from + 1);
  }
  return text;
}

std::string wrapped_lines(std::string_view text, int width) {
  constexpr int kHanging = 2;
  std::string out;
  for (const auto& line : split(text, '\n')) {
    const auto room = display_width(line) <= static_cast<std::size_t>(width) ? width : width - kHanging;
    const auto parts = wrapped(line, static_cast<std::size_t>(std::max(room, 0)));
    for (std::size_t i = 0; i < parts.size(); ++i)
      out.append(i == 0 ? 0 : kHanging, ' ').append(parts[i]).append(1, '\n');
  }
  if (text.empty() || text.ends_with('\n')) out.pop_back();
  return out;
}

std::string markdown_table(const std::vector<TableRow>& rows) {
  std::string text;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const auto& cell : rows[i]) {
      text += "| ";
      for (const char c : clean_line(cell)) {
        if (c == '|' || c == '<') text += '\\';
        text += c;
      }
      text += ' ';
    }
    text += "|\n";
    if (i > 0) continue;
    for (std::size_t column = 0; column < rows[i].size(); ++column) text += "|---";
    text += "|\n";
  }
  return text;
}

}  // namespace orbs
