#pragma once

#include "registry/cases.h"
#include "registry/run_settings.h"

#include <set>
#include <string>
#include <vector>

namespace orbs::registry {

/// The cases that the settings choose, each with the targets that they choose. Scenes from which only a
/// chosen difference is made stay in the case. InputError when a filter matches nothing, or all of them
/// together leave no scene.
std::vector<Case> choose_cases(const std::vector<Case>& all, const RunSettings& settings);

/// The case with these targets alone, and the scenes that its chosen differences are made from.
Case with_targets(const Case& whole, const std::set<std::string>& chosen);

}  // namespace orbs::registry
