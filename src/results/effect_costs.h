#pragma once

#include "results/record.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// What orbs effect-cost has found (format "orbs-effect-cost/1"), as far as runs repeat it.
namespace orbs::results {

/// Beside the references of the suite.
inline constexpr const char* kEffectCostsFile = "effect-costs.json";

/// By scene; nothing when there is no file. InputError with file, line and key.
std::map<std::string, std::vector<EffectCostRecord>> read_effect_costs(const std::filesystem::path& file);

}  // namespace orbs::results
