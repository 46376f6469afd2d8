#pragma once

#include "base/terminal.h"
#include "studies/stability/record.h"

#include <string>

namespace orbs::studies {

/// "the mean is off by -4.6 % +- 0.1 %, the block at (16, 8) by -17 % +- 1 %".
std::string break_text(const StabilityStep& step);

/// What a renderer follows and where it ends, in one or more sentences: "cycles: 20 of 22 changes leave the
/// image right. The world moved, by its matrices: right to 1000 m, breaks at 10000 m (block-on-ground)."
std::string stability_summary(const StabilityRecord& record, std::size_t renderer);

/// The matrix of relations and renderers, the first breaks, and how all was measured, for a terminal.
std::string stability_table(const StabilityRecord& record, const TerminalStyle& style);

/// The same in Markdown.
std::string stability_markdown(const StabilityRecord& record);

}  // namespace orbs::studies
