#pragma once

#include "scene/geometry/mesh_file.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace orbs::scene {

/// PLY, ASCII or binary: vertex x y z nx ny nz and optionally tx ty tz and texture coordinates by any of
/// their usual names (u v, s t, texture_u texture_v, ...); face vertex_indices (or vertex_index) and
/// optionally an integer `material` and a list `texcoord` with u and v of each corner, which replace those of
/// the vertices. InputError with file, element, row, and of ASCII the line, that says what is missing.
MeshFile read_ply(const std::filesystem::path& file, FileNormals normals = FileNormals::Required);
MeshFile parse_ply(const std::string& name,
                   std::string_view bytes,
                   FileNormals normals = FileNormals::Required);

/// All attributes, with the material as an int per face; or what every reader of PLY knows: positions,
/// normals, u and v, and the faces.
enum class PlyContent { Everything, Common };

/// Binary little-endian PLY.
void write_ply(const Mesh& mesh,
               const std::filesystem::path& file,
               PlyContent content = PlyContent::Everything);

}  // namespace orbs::scene
