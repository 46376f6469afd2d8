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
  std::vector<Vec2f> uvs;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};
Vertices vertices_of(const scene::Mesh& mesh);

/// The mesh under a matrix without its translation.
scene::Mesh sheared(scene::Mesh mesh, const Mat4& matrix);

}  // namespace orbs::adapters::gltf
