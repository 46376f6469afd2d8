#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

namespace orbs::adapters {

/// One reason for each thing in the scene that pbrt-v4 cannot draw as ORB.S means it; empty when there is
/// none. Reads the sizes of textures; InputError when one cannot be read. Not among the limits: pbrt
/// chooses between a mirror's two materials (materials.cpp) by hashes of their addresses, so that the noise
/// of such a surface differs from run to run for one seed.
std::vector<std::string> pbrt_limits(const scene::Scene& scene);

}  // namespace orbs::adapters
