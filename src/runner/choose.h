#pragma once

#include "runner/plan.h"

#include <vector>

namespace orbs::runner {

/// The cases with the images that the settings choose. Scenes that only serve a chosen difference stay in,
/// too.
std::vector<registry::Case> choose_cases(const std::vector<registry::Case>& all,
                                         const registry::Defaults& settings);

/// Fills plan.renderers and plan.left_out. A renderer that is named in full must be there; one that a pattern
/// catches is left out when it is not.
void choose_renderers(const registry::Configuration& configuration, Plan& plan);

}  // namespace orbs::runner
