#pragma once

#include "results/record.h"

#include <optional>
#include <string>

namespace orbs::report {

struct TableStyle {
  bool colour = false;        // ANSI escapes
  int width = 0;              // columns of the terminal, see terminal_width; 0: no limit
  bool whole_reasons = true;  // else one short sentence of each
};

/// Colour if `descriptor` is a terminal that supports it and the user did not set NO_COLOR
/// (https://no-color.org), and the width of that terminal.
TableStyle style_for(int descriptor);

/// The summary at the end of a run: one line per requirement with a column per renderer (lowest PSNR and
/// verdict), what each renderer declares and what was measured, and a reason for everything that is no
/// pass.
std::string summary_text(const results::RunRecord& run, const TableStyle& style);

/// "41.20", "inf", "-" for none.
std::string decibels(const std::optional<double>& value);

/// "37.2 dB without noise", which is certain, beside the image's own PSNR.
std::string without_noise_text(double db);
/// What stands where a table has such numbers.
inline constexpr std::string_view kWithoutNoiseRule =
    "Numbers are the PSNR of the images in dB. Where an image's own noise keeps it below the gate, it passes if "
    "its error without the noise, which two halves of its samples show, is small enough for certain: the PSNR "
    "that it has at least without noise stands beside its own.";

}  // namespace orbs::report
