#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace orbs::scene {

/// A mesh as a file holds it: its materials are still names of the file, until the reader of scenes maps
/// them.
struct MeshFile {
  Mesh mesh;            // triangle_materials index into material_names
  Vec3d origin_m = {};  // the places of the vertices are relative to it, see placed_vertices
  std::vector<std::string> material_names;
  bool names_are_slots = false;  // PLY: the materials are indices into a list outside of the file
  bool lacks_normals = false;    // then they are zero
};

/// Whether a file must have normals, or may leave them to be computed.
enum class FileNormals { Required, MayLack };

/// Stores the places of all vertices.
void place_vertices(const std::vector<Vec3d>& vertices, MeshFile& file);

/// Wavefront OBJ: v, vt, vn, f (polygons become fans), usemtl. Normals are used as given; where they
/// may lack, all corners have one or none has. InputError with file and line.
MeshFile read_obj(const std::filesystem::path& file, FileNormals normals = FileNormals::Required);
MeshFile parse_obj(const std::string& name,
                   std::string_view text,
                   FileNormals normals = FileNormals::Required);

}  // namespace orbs::scene
