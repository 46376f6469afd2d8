#include "adapters/gltf/vertices.h"

#include "base/error.h"
#include "scene/geometry/uv_frames.h"

#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

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

std::vector<Vec2f> from_the_top(std::vector<Vec2f> uvs) {
  for (Vec2f& uv : uvs) uv.y = static_cast<float>(1 - double{uv.y});
  return uvs;
}

scene::Mesh with_a_vertex_for_each_corner(const scene::Mesh& mesh) {
  scene::Mesh out;
  out.name = mesh.name;
  for (const auto& triangle : mesh.triangles) {
    const auto first = scene::vertex_count(out);
    for (const std::uint32_t corner : triangle) append_vertex(out, mesh, corner);
    out.triangles.push_back({first, first + 1, first + 2});
  }
  return out;
}

// A normal that lies along u leaves no direction: the tangent is then any one across it, as glTF wants a
// length of 1, while the built-in tracer takes no notice of the map there.
std::array<float, 4> tangent_at(const scene::UvFrame& frame, Vec3d normal) {
  const Vec3d other = cross(std::abs(normal.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}, normal);
  const Vec3f t = unit(tangent_across(frame, normal).value_or(other));
  return {t.x, t.y, t.z, is_mirrored(frame) ? -1.0F : 1.0F};
}

}  // namespace

bool has_tangents(const scene::Mesh& mesh, int uv_set) {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (!scene::uv_frame(mesh, i, uv_set)) return false;
  return true;
}

Vertices vertices_with_tangents(const scene::Mesh& mesh, int uv_set) {
  const scene::Mesh split = with_a_vertex_for_each_corner(mesh);
  Vertices out = vertices_of(split);
  for (std::size_t i = 0; i < split.triangles.size(); ++i) {
    const auto frame = scene::uv_frame(split, i, uv_set);
    if (!frame)
      throw InputError(
          fmt::format("mesh '{}': triangle {} has its texture coordinates on one line, where "
                      "normal maps have no tangents",
                      mesh.name, i));
    for (const std::uint32_t corner : split.triangles[i])
      out.tangents.push_back(tangent_at(*frame, cast<double>(out.normals[corner])));
  }
  return out;
}

Vertices vertices_of(const scene::Mesh& mesh) {
  Vertices out{mesh.positions, {}, {}, from_the_top(mesh.uvs), from_the_top(mesh.second_uvs), mesh.triangles};
  for (const Vec3f normal : mesh.normals) out.normals.push_back(unit(cast<double>(normal)));
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
