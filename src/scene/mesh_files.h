#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace orbs::scene {

/// A mesh as a file holds it: materials are still words of the file.
struct MeshFile {
  Mesh mesh;  // triangle_materials index into material_names
  std::vector<std::string> material_names;
  bool names_are_slots = false;  // PLY: numbers of a list that stands elsewhere, no names
};

/// Wavefront OBJ: v, vt, vn, f (polygons become fans), usemtl; normals are required, nothing is recomputed.
/// InputError with file and line.
MeshFile read_obj(const std::filesystem::path& file);
MeshFile parse_obj(const std::string& name, std::string_view text);

/// PLY, ASCII or binary little-endian: vertex x y z nx ny nz and optionally tx ty tz, u v (or s t); face
/// vertex_indices (or vertex_index) and optionally an integer `material`. InputError naming what is missing.
MeshFile read_ply(const std::filesystem::path& file);
MeshFile parse_ply(const std::string& name, std::string_view bytes);

/// All attributes, with the material as an int per face; or what every reader of PLY knows: positions,
/// normals, u and v, and the faces.
enum class PlyContent { Everything, Common };

/// Binary little-endian PLY.
void write_ply(const Mesh& mesh,
               const std::filesystem::path& file,
               PlyContent content = PlyContent::Everything);

/// The complaint about a mesh that cannot be drawn as given ("" when it can): array lengths, indices beyond
/// the vertices, numbers that are not finite, normals of length zero.
std::string mesh_problem(const Mesh& mesh);

}  // namespace orbs::scene
