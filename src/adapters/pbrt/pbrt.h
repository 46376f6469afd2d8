#pragma once

#include "adapters/exporter.h"
#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace orbs::adapters {

/// Writes the scene for pbrt-v4 to `file`, each mesh to `<stem>-mesh<i>.ply` and each channel of the image of
/// a textured material to `<stem>-material<i>-<r, g or b>.exr` beside it. Samples, seed and output come from
/// pbrt's command line. Lower the scene first; pbrt_limits must be empty. InputError when a file cannot be
/// read or written.
void write_pbrt(const scene::Scene& scene, const std::filesystem::path& file);

/// pbrt's row in the table of exporters.
Exporter pbrt_exporter();

/// One reason for each thing in the scene that pbrt-v4 cannot draw as ORB.S means it; empty when there is
/// none. Reads the sizes of textures; InputError when one cannot be read. Not among the limits: pbrt
/// chooses between a mirror's two materials (materials.cpp) by hashes of their addresses, so that the noise
/// of such a surface differs from run to run for one seed.
std::vector<std::string> pbrt_limits(const scene::Scene& scene);

}  // namespace orbs::adapters
