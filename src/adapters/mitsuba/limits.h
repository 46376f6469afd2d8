#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

namespace orbs::adapters {

/// Whatever of the scene Mitsuba 3 cannot draw as ORB.S means it, one reason each; empty when it can draw all
/// of it. Reads only the scene, no file.
std::vector<std::string> mitsuba_limits(const scene::Scene& scene);

}  // namespace orbs::adapters
