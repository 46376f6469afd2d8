#pragma once

#include "adapters/exporter.h"
#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace orbs::adapters {

/// Writes the scene as Mitsuba 3 XML to `file`, each mesh to `<stem>-mesh<i>.ply` and the image of each
/// textured material to `<stem>-material<i>.exr` beside it. For the variants scalar_rgb and llvm_ad_rgb,
/// which multiply RGB as ORB.S does, where scene::transport of the scene is Rgb; else for scalar_spectral,
/// or scalar_spectral_polarized where it is Polarised. Samples and seed are left open as `spp` and `seed` (-D
/// spp=64). Lower the scene first; mitsuba_limits must be empty. InputError when a file cannot be read or
/// written.
void write_mitsuba(const scene::Scene& scene, const std::filesystem::path& file);

/// Mitsuba's row in the table of exporters.
Exporter mitsuba_exporter();

/// One reason for each thing in the scene that Mitsuba 3 cannot draw as ORB.S means it; empty when there is
/// none. Reads only the scene, no file.
std::vector<std::string> mitsuba_limits(const scene::Scene& scene);

}  // namespace orbs::adapters
