#pragma once

#include "scene/scene.h"

#include <string>
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

}  // namespace orbs::scene
