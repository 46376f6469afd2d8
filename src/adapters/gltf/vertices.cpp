#include "adapters/gltf/vertices.h"

#include <utility>

namespace orbs::adapters::gltf {

namespace {

Vec3f unit(Vec3d normal) { return cast<float>(normalised(normal)); }

// ORB.S takes the side from the normals alone.
bool is_wound_against_its_normals(const scene::Mesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const auto corner = [&](std::size_t i) { return cast<double>(mesh.positions[triangle[i]]); };
  const auto normal = [&](std::size_t i) { return cast<double>(mesh.normals[triangle[i]]); };
  const Vec3d face = cross(corner(1) - corner(0), corner(2) - corner(0));
  return dot(face, normal(0) + normal(1) + normal(2)) < 0;
}

}  // namespace

Vertices vertices_of(const scene::Mesh& mesh) {
  Vertices out{mesh.positions, {}, {}, mesh.triangles};
  for (const Vec3f normal : mesh.normals) out.normals.push_back(unit(cast<double>(normal)));
  for (const Vec2f uv : mesh.uvs) out.uvs.push_back({uv.x, static_cast<float>(1 - double{uv.y})});
  for (auto& triangle : out.triangles)
    if (is_wound_against_its_normals(mesh, triangle)) std::swap(triangle[1], triangle[2]);
  return out;
}

scene::Mesh sheared(scene::Mesh mesh, const Mat4& matrix) {
  const Mat4 to_local = inverse(matrix).value();  // the loader lets only invertible matrices through
  for (Vec3f& p : mesh.positions) p = cast<float>(transform_direction(matrix, cast<double>(p)));
  for (Vec3f& n : mesh.normals) n = unit(transform_normal(to_local, cast<double>(n)));
  return mesh;
}

}  // namespace orbs::adapters::gltf
