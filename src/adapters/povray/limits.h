#pragma once

#include "adapters/povray/settings.h"

#include <string>
#include <vector>

namespace orbs::adapters {

/// One reason for each thing in the scene that POV-Ray 3.7 cannot draw; empty when there is none. Slow or
/// noisy rendering is no reason. Reads only the scene, no file.
std::vector<std::string> povray_limits(const scene::Scene& scene, const PovraySettings& settings = {});

}  // namespace orbs::adapters
