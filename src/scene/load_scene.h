#pragma once

#include "json/object_reader.h"
#include "scene/scene.h"

#include <filesystem>

namespace orbs::scene {

/// What one scene may hold: more is a mistake, or meant to exhaust the machine. Some 4 GB.
struct SceneBudget {
  std::size_t triangles = std::size_t{1} << 26;  // stored once for each mesh
  std::size_t instances = std::size_t{1} << 22;
};

/// Reads and checks an orbs-scene/1 file. Paths in it are relative to the file's folder. InputError with
/// file, line and key for whatever is wrong: unknown keys, types, ranges, dangling names, files that are not
/// there, singular matrices.
Scene load_scene(const std::filesystem::path& file);

/// As load_scene, for a text that has no file yet; `folder` is what paths are relative to.
Scene load_scene_text(const std::string& name,
                      const std::string& text,
                      const std::filesystem::path& folder,
                      SceneBudget budget = {});

}  // namespace orbs::scene
