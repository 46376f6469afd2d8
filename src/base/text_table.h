#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// Tables of text for a terminal.
namespace orbs {

/// The columns that `text` takes on a terminal: one per code point of UTF-8, none for ANSI escapes.
std::size_t display_width(std::string_view text);

enum class Align { Left, Right };

using TableRow = std::vector<std::string>;

/// Rows of cells as lines. Each column is as wide as its widest cell, and two spaces part it from the next
/// one. Columns that `columns` does not name are aligned left. A row may have fewer cells than others.
std::string text_table(const std::vector<TableRow>& rows, const std::vector<Align>& columns = {});

}  // namespace orbs
