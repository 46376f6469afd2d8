#pragma once

#include "adapters/povray/settings.h"

#include <string>
#include <vector>

namespace orbs::adapters {

/// Whatever of the scene POV-Ray 3.7 cannot do, one reason each; empty when it can do all of it. Slow or
/// noisy rendering is no reason. Reads only the scene, no file.
std::vector<std::string> povray_limits(const scene::Scene& scene, const PovraySettings& settings = {});

}  // namespace orbs::adapters
