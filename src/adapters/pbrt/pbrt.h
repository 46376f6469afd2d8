#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace orbs::adapters {

/// What of the scene pbrt-v4 cannot draw as ORB.S means it, one reason each; empty when it can. Reads the
/// sizes of textures; InputError when one cannot be read. Not among the limits: pbrt is always spectral, so
/// that coloured surfaces differ from RGB by some percent after a few bounces.
std::vector<std::string> pbrt_limits(const scene::Scene& scene);

/// Writes the scene for pbrt-v4 to `file`, each mesh to `<stem>-mesh<i>.ply` and the image of each textured
/// material to `<stem>-material<i>.exr` beside it. Samples, seed and output come from pbrt's command line.
/// Lower the scene first; pbrt_limits must be empty. InputError when a file cannot be read or written.
void write_pbrt(const scene::Scene& scene, const std::filesystem::path& file);

}  // namespace orbs::adapters
