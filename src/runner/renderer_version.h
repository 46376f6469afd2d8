#pragma once

#include "runner/plan.h"

#include <string>

namespace orbs::runner {

/// The first line of what the version command prints that is not empty and starts with version_prefix;
/// "unknown" with the reason when there is none, "" when the renderer has no such command.
std::string renderer_version(const ChosenRenderer& renderer, const Plan& plan);

}  // namespace orbs::runner
