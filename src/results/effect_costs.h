#pragma once

#include "results/record.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// The results of orbs effect-cost (format "orbs-effect-cost/1") that runs repeat.
namespace orbs::results {

/// Its name beside the references of the suite.
inline constexpr const char* kEffectCostsFile = "effect-costs.json";

/// The costs by scene; empty if there is no file. InputError with file, line and key.
std::map<std::string, std::vector<EffectCostRecord>> read_effect_costs(const std::filesystem::path& file);

/// How they were measured; nothing if there is no file. InputError likewise.
std::optional<EffectStudyRecord> read_effect_study(const std::filesystem::path& file);

}  // namespace orbs::results
