#pragma once

#include "studies/effects/effect_cost.h"

#include <string>
#include <vector>

namespace orbs::studies {

/// The results as a table for a terminal, one line for each alternative.
std::string effect_cost_table(const EffectCosts& list, int width);
/// The same as a table in Markdown.
std::string effect_cost_markdown(const EffectCosts& list);
/// All numbers, format "orbs-effect-cost/1".
std::string effect_cost_json(const EffectCosts& list);

}  // namespace orbs::studies
