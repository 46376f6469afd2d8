#pragma once

#include "base/matrix.h"
#include "scene/geometry/mesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace orbs::adapters::gltf {

/// A mesh in the terms of glTF: normals of length 1; v is 0 in the top row of the image; and the front of a
/// triangle, from which its corners run counter-clockwise, is the side that its normals point to.
struct Vertices {
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;
  /// For normal maps, else none: along increasing u, of length 1, and the side of increasing v (upwards in
  /// the image), 1 where that is normal x tangent and -1 on the other side.
  std::vector<std::array<float, 4>> tangents;
  std::vector<Vec2f> uvs;
  std::vector<Vec2f> second_uvs;  // none where the mesh has none
  std::vector<std::array<std::uint32_t, 3>> triangles;
};
Vertices vertices_of(const scene::Mesh& mesh);

/// With the tangents of each triangle by one of its sets of coordinates. Ours belong to triangles and those
/// of glTF to vertices: no triangles share one here. InputError where has_tangents is false.
Vertices vertices_with_tangents(const scene::Mesh& mesh, int uv_set);

/// Whether no triangle has its coordinates on one line. The specification gives no tangents there.
bool has_tangents(const scene::Mesh& mesh, int uv_set);

/// The mesh under a matrix without its translation.
scene::Mesh sheared(scene::Mesh mesh, const Mat4& matrix);

}  // namespace orbs::adapters::gltf
