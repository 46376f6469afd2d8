#pragma once

#include "scene/load/entry.h"
#include "scene/scene.h"

#include <filesystem>
#include <vector>

namespace orbs::scene {

/// Reads and checks an orbs-scene/1 file. Paths in it are relative to the file's folder, and must lead into
/// that folder or one of `data_folders`; if there are none, they may lead anywhere. InputError with file,
/// line and key for anything that is wrong: unknown keys, types, ranges, dangling names, files that are not
/// there, singular matrices. A file may hold several cameras: `camera` is the name of one of "cameras"; "" is
/// that of "camera". All are checked, and the scene has the chosen one alone.
Scene load_scene(const std::filesystem::path& file,
                 const std::vector<std::filesystem::path>& data_folders = {},
                 const std::string& camera = "");

/// As load_scene, for a text that has no file yet; `folder` is what paths are relative to.
Scene load_scene_text(const std::string& name,
                      const std::string& text,
                      const std::filesystem::path& folder,
                      SceneBudget budget = {},
                      const std::string& camera = "");

}  // namespace orbs::scene
