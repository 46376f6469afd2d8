#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

namespace orbs::adapters {

/// Whatever of the scene pbrt-v4 cannot draw as ORB.S means it, one reason each; empty when it can draw all
/// of it. Reads the sizes of textures; InputError when one cannot be read. Not among the limits: pbrt
/// chooses between a mirror's two materials (materials.cpp) by hashes of their addresses, so that the noise
/// of such a surface is another one in each run, whatever the seed.
std::vector<std::string> pbrt_limits(const scene::Scene& scene);

}  // namespace orbs::adapters
