#pragma once

#include "results/record.h"

#include <string>
#include <string_view>
#include <vector>

namespace orbs::report {

struct TableStyle {
  bool colour = false;  // ANSI escapes
};

/// Colour when `descriptor` is a terminal that can do it and the user did not set NO_COLOR
/// (https://no-color.org).
TableStyle style_for(int descriptor);

/// What stands at the end of a run: one line per requirement with a column per renderer (lowest PSNR and
/// verdict), what each renderer declares and what was measured, and a reason for everything that is no
/// pass.
std::string summary_text(const results::RunRecord& run, const TableStyle& style);

/// Columns that `text` takes on a terminal: one per code point of UTF-8, none for ANSI escapes.
std::size_t display_width(std::string_view text);

/// `text` with spaces behind it up to `width` columns.
std::string padded(std::string_view text, std::size_t width);

/// Rows of cells as lines, each column as wide as its widest cell.
std::string aligned(const std::vector<std::vector<std::string>>& rows);

/// "41.20", "inf", "-" for none.
std::string decibels(const std::optional<double>& value);

}  // namespace orbs::report
