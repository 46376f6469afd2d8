#pragma once

#include "scene/mesh_file.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace orbs::scene {

/// Wavefront OBJ: v, vt, vn, f (polygons become fans), usemtl; normals are required, nothing is recomputed.
/// InputError with file and line.
MeshFile read_obj(const std::filesystem::path& file);
MeshFile parse_obj(const std::string& name, std::string_view text);

}  // namespace orbs::scene
