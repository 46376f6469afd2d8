#pragma once

#include "adapters/exporter.h"
#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace orbs::adapters {

/// How HydraCore3 is to follow the paths of a scene.
struct HydraPaths {
  int trace_depth = 1;     // as it counts
  bool is_direct = false;  // in its layer of direct light, in place of all light
};

/// The settings have "naive": 1 for its integrator naivept, which finds light by sampling surfaces alone and
/// then traces one ray more. The others, mispt and shadowpt, sample lights at each of `trace_depth` surfaces
/// and trace no ray behind the last:
///  - where there is no light but the environment and emissive surfaces, one more surface is exact;
///  - beside lamps, an environment gets one more surface, too: without it all its light at the last surface
///    would be lost, and with it the lamps give a part of one scattering too much;
///  - direct light is exact as their layer of direct light with one more surface, in which mirrors and glass
///    do not count;
///  - else mispt finds too little light at the last surface, and with one more surface too much.
HydraPaths hydra_paths(const scene::Scene& scene, const SceneSettings& settings);

/// Writes the scene for HydraCore3 of January 2026 to `file`, everything else beside it: meshes as VSGF,
/// textures as its own images, IES profiles on a grid of their own. Ids are positions, as it reads no names.
/// Samples and output come from its command line. Lower the scene first; hydra_limits must be empty.
/// InputError when a file cannot be read or written.
void write_hydra(const scene::Scene& scene, const SceneSettings& settings, const std::filesystem::path& file);

/// HydraCore3's row in the table of exporters.
Exporter hydra_exporter();

/// One reason for each thing in the scene that HydraCore3 cannot draw as ORB.S means it; empty when there is
/// none. Reads only the scene, no file.
std::vector<std::string> hydra_limits(const scene::Scene& scene, const SceneSettings& settings = {});

}  // namespace orbs::adapters
