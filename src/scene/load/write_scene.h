#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <string>

namespace orbs::scene {

/// Writes `scene` as orbs-scene/1 that load_scene reads back to the same scene: one JSON file, and one binary
/// PLY per mesh in the same folder, named <stem>.<mesh index>.ply. Textures and IES profiles stay where they
/// are, by absolute path.
/// With `says_calls` also "calls_for", the words of light_switches, for renderers that switch them.
void write_scene(const Scene& scene, const std::filesystem::path& file, bool says_calls = false);

}  // namespace orbs::scene
