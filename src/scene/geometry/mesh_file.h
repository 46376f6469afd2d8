#pragma once

#include "scene/scene.h"

#include <functional>
#include <string>
#include <vector>

namespace orbs::scene {

/// A mesh as a file holds it: its materials are still names of the file, until the reader of scenes maps
/// them.
struct MeshFile {
  Mesh mesh;            // triangle_materials index into material_names; -1 where a face has none
  Vec3d origin_m = {};  // the places of the vertices are relative to it, see placed_vertices
  std::vector<std::string> material_names;
  std::vector<int> material_lines;    // where in the file each name stands first
  bool names_are_slots = false;       // PLY: the materials are indices into a list outside of the file
  std::vector<std::string> warnings;  // file, line and the oddity that was accepted
};

/// Whether all corners of a file must have normals, or may leave them to be computed: normals that are absent
/// are zero then.
enum class FileNormals { Required, MayLack };

/// The faces of a file, until it has been read to its end and all vertices are known.
struct Polygons {
  std::vector<std::uint32_t> corners;  // vertices, face after face
  std::vector<std::uint32_t> sizes;    // by face: how many corners it has, 3 or more
  std::vector<int> materials;          // by face
};

/// Stores the places of all vertices.
void place_vertices(const std::vector<Vec3d>& vertices, MeshFile& file);

/// Appends the triangles of the faces, whose corners are vertices that have been placed, as triangulate()
/// makes them. `place_of` says for messages where a face stands: "roof.obj:12". The first of those that cross
/// themselves is warned of.
void add_triangles(const Polygons& faces,
                   const std::function<std::string(std::size_t)>& place_of,
                   MeshFile& file);

}  // namespace orbs::scene
