#include "base/text_table.h"

#include <algorithm>

namespace orbs {

namespace {

std::vector<std::size_t> column_widths(const std::vector<TableRow>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    if (row.size() > widths.size()) widths.resize(row.size(), 0);
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], display_width(row[i]));
  }
  return widths;
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

std::string text_table(const std::vector<TableRow>& rows, const std::vector<Align>& columns) {
  const auto widths = column_widths(rows);
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string spaces(widths[i] - display_width(row[i]), ' ');
      const bool is_right = i < columns.size() && columns[i] == Align::Right;
      if (i > 0) line += "  ";
      line += is_right ? spaces + row[i] : row[i] + spaces;
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

}  // namespace orbs
