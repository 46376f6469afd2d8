#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

namespace orbs::adapters {

/// One reason for each thing in the scene that Mitsuba 3 cannot draw as ORB.S means it; empty when there is
/// none. Reads only the scene, no file.
std::vector<std::string> mitsuba_limits(const scene::Scene& scene);

}  // namespace orbs::adapters
