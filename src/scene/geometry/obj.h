#pragma once

#include "scene/geometry/mesh_file.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace orbs::scene {

/// Wavefront OBJ: v, vt, vn, f, usemtl, whose name is the rest of its line. What has no surface (points,
/// lines, names) is left out; curves and surfaces are refused. Normals are used as given. InputError with
/// file and line.
MeshFile read_obj(const std::filesystem::path& file, FileNormals normals = FileNormals::Required);
MeshFile parse_obj(const std::string& name,
                   std::string_view text,
                   FileNormals normals = FileNormals::Required);

}  // namespace orbs::scene
