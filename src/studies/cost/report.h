#pragma once

#include "base/statistics.h"
#include "base/terminal.h"
#include "studies/cost/record.h"

#include <string>

namespace orbs::studies {

/// "2.08 (1.83 to 2.37)".
std::string ratio_text(const Interval& ratio);

/// For a terminal: the time to the error nearest the study's target, per scene and renderer; who is faster
/// over all scenes; floors; and the comparison of a renderer with itself, without which nothing is ranked.
/// Green is a time that is shown to be the shortest of its scene, faint what is no time.
std::string cost_table(const CostRecord& record, const TerminalStyle& style);

/// The same as Markdown, with the times to every error.
std::string cost_markdown(const CostRecord& record);

}  // namespace orbs::studies
