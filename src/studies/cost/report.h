#pragma once

#include "studies/cost/record.h"

#include <string>

namespace orbs::studies {

/// For a terminal: the time to the error nearest the study's target, per scene and renderer; who is faster
/// over all scenes; floors; and the comparison of a renderer with itself, without which nothing is ranked.
std::string cost_table(const CostRecord& record);

/// The same as Markdown, with the times to every error.
std::string cost_markdown(const CostRecord& record);

}  // namespace orbs::studies
