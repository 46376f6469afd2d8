#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Tables of text, for a terminal or a document.
namespace orbs {

/// The columns that `text` takes on a terminal: one per code point of UTF-8, none for ANSI escapes.
std::size_t display_width(std::string_view text);

enum class Align { Left, Right };

using TableRow = std::vector<std::string>;

/// ANSI colours of cells, by row and column.
using CellColours = std::map<std::pair<std::size_t, std::size_t>, std::string_view>;

struct TableLook {
  int width = 0;  // columns of the terminal, see terminal_width; 0: no limit
  CellColours colours = {};
};

/// Rows of cells as lines. Each column is as wide as its widest cell, and two spaces part it from the next
/// one. Columns that `columns` does not name are aligned left. A row may have fewer cells than others. Cells
/// may hold text of strangers: each goes through clean_line. Where the lines are wider than the terminal, the
/// cells of the last column are broken between words, and columns without room go on below, indented.
std::string text_table(const std::vector<TableRow>& rows,
                       const std::vector<Align>& columns = {},
                       const TableLook& look = {});

/// Whether the rows stand beside each other as they are, so that no cell has to go on below.
bool fits(const std::vector<TableRow>& rows, int width);

/// Tables below each other where one is wider than the terminal: each has the first `kept` columns and as
/// many of the others as there is room for.
std::string text_tables(const std::vector<TableRow>& rows, std::size_t kept, const TableLook& look);

/// The same rows as a table of Markdown (GitHub Flavored Markdown, section 4.10); the first is its head.
/// Cells may hold text of strangers: each goes through clean_line, and what would end a cell or begin a tag
/// is escaped.
std::string markdown_table(const std::vector<TableRow>& rows);

/// The text in lines of at most `width` columns, broken between words; a longer word stays whole. `width` 0:
/// one line. At least one line.
std::vector<std::string> wrapped(std::string_view text, std::size_t width);

/// Each line of the text wrapped, as one text; what goes on is indented by two.
std::string wrapped_lines(std::string_view text, int width);

}  // namespace orbs
