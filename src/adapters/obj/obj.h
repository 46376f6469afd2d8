#pragma once

#include "adapters/exporter.h"
#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace orbs::adapters {

/// Writes the scene for programs that read meshes and no scene: OBJ to `file` with an object for each
/// placement of a mesh, in world space, MTL beside it as `<stem>.mtl`, and description.json with all that
/// these cannot say. InputError when a file cannot be read or written.
void write_obj(const scene::Scene& scene, const std::filesystem::path& file);

/// The same with a binary PLY for each placement of a mesh. description.json, which is `file`, lists them.
void write_ply_parts(const scene::Scene& scene, const std::filesystem::path& file);

/// One reason for each thing in the scene that neither the meshes nor the description can say; empty when
/// there is none. The same for both formats.
std::vector<std::string> obj_limits(const scene::Scene& scene);

/// The rows in the table of exporters.
Exporter obj_exporter();
Exporter ply_exporter();

}  // namespace orbs::adapters
