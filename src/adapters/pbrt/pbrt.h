#pragma once

#include "adapters/exporter.h"
#include "scene/scene.h"

#include <filesystem>

namespace orbs::adapters {

/// Writes the scene for pbrt-v4 to `file`, each mesh to `<stem>-mesh<i>.ply` and each channel of the image of
/// a textured material to `<stem>-material<i>-<r, g or b>.exr` beside it. Samples, seed and output come from
/// pbrt's command line. Lower the scene first; pbrt_limits must be empty. InputError when a file cannot be
/// read or written.
void write_pbrt(const scene::Scene& scene, const std::filesystem::path& file);

/// pbrt's row in the table of exporters.
Exporter pbrt_exporter();

}  // namespace orbs::adapters
