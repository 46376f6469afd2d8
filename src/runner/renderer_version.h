#pragma once

#include "runner/plan.h"

#include <string>

namespace orbs::runner {

/// What the version command prints: the group of version_pattern in the first line that matches it, or the
/// first line that is not empty. "unknown" with the reason when there is none, "" when the renderer has no
/// such command.
std::string renderer_version(const ChosenRenderer& renderer, const Plan& plan);

}  // namespace orbs::runner
