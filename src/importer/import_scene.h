#pragma once

#include "importer/camera.h"
#include "importer/report.h"
#include "scene/scene.h"

#include <filesystem>
#include <string>

namespace orbs::importer {

/// Reads a scene of glTF 2.0 and writes it to the folder, which is there and empty, as `scene.json` with its
/// meshes and textures. What is not as in the file goes to the report. Returns the scene as it reads from
/// there. InputError where the file is broken; the folder may then hold a part of it.
scene::Scene import_scene(const std::filesystem::path& file,
                          const std::filesystem::path& folder,
                          const std::string& name,
                          const View& view,
                          Report& report);

}  // namespace orbs::importer
