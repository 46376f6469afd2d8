#pragma once

#include "registry/cases.h"
#include "registry/run_settings.h"

#include <vector>

namespace orbs::registry {

/// The cases that the settings choose, each with the targets that they choose. Scenes from which only a
/// chosen difference is made stay in the case. InputError when a filter matches nothing, or all of them
/// together leave no scene.
std::vector<Case> choose_cases(const std::vector<Case>& all, const RunSettings& settings);

}  // namespace orbs::registry
