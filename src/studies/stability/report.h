#pragma once

#include "studies/stability/record.h"

#include <string>

namespace orbs::studies {

/// "the mean is off by -4.6 % +- 0.1 %, the block at (16, 8) by -17 % +- 1 %".
std::string break_text(const StabilityStep& step);

/// The matrix of relations and renderers, the first breaks, and how all was measured, for a terminal.
std::string stability_table(const StabilityRecord& record);

/// The same in Markdown.
std::string stability_markdown(const StabilityRecord& record);

}  // namespace orbs::studies
