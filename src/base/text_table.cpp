#include "base/text_table.h"

#include "base/terminal.h"
#include "base/text.h"

#include <algorithm>

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

// Where the last column starts, and how wide it may be: 0 for any width. A last column that would have too
// little room starts further left, below the cells before it.
struct LastColumn {
  std::size_t start = 0;
  std::size_t width = 0;
  bool below = false;
};

LastColumn last_column(const std::vector<std::size_t>& widths, std::size_t terminal) {
  constexpr std::size_t kLeast = 30;
  constexpr std::size_t kIndent = 6;
  LastColumn last;
  for (std::size_t i = 0; i + 1 < widths.size(); ++i) last.start += widths[i] + kGap;
  if (widths.empty() || terminal == 0 || last.start + widths.back() <= terminal) return last;
  if (widths.size() > 1 && last.start + kLeast > terminal) last = {kIndent, 0, true};
  last.width = std::max(terminal, last.start + 1) - last.start;
  return last;
}

std::string padded(const std::string& cell, std::size_t width, Align align) {
  const std::string spaces(width - display_width(cell), ' ');
  return align == Align::Right ? spaces + cell : cell + spaces;
}

std::string painted(const std::string& text, std::string_view colour) {
  return std::string(colour) + text + std::string(colour::kNone);
}

// The lines of a cell of the last column behind `line`, what stands left of it.
std::string with_last_cell(std::string line, const std::string& cell, const LastColumn& last) {
  if (last.width == 0) return line + cell;
  if (last.below && !cell.empty()) {
    line.erase(line.find_last_not_of(' ') + 1);
    line += '\n' + std::string(last.start, ' ');
  }
  const auto parts = wrapped(cell, last.width);
  line += parts.front();
  for (std::size_t i = 1; i < parts.size(); ++i) line += '\n' + std::string(last.start, ' ') + parts[i];
  return line;
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
  const auto last = last_column(widths, static_cast<std::size_t>(look.width));
  std::string text;
  for (std::size_t r = 0; r < clean.size(); ++r) {
    std::string line;
    for (std::size_t i = 0; i < clean[r].size(); ++i) {
      if (i > 0) line += std::string(kGap, ' ');
      const auto colour = look.colours.find({r, i});
      const auto align = i < columns.size() ? columns[i] : Align::Left;
      const auto cell = colour == look.colours.end() ? clean[r][i] : painted(clean[r][i], colour->second);
      const bool is_broken = i + 1 == widths.size() && last.width > 0;
      const auto shown = is_broken ? cell : padded(cell, widths[i], align);
      line = i + 1 == widths.size() ? with_last_cell(std::move(line), shown, last) : line + shown;
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
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
