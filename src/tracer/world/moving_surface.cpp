#include "tracer/world/moving_surface.h"

#include "base/nth.h"
#include "tracer/geometry/transforms.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace orbs::tracer {

namespace {

Vec3f vertex_at(const std::vector<Vec3f>& start,
                const std::vector<Vec3f>& end,
                std::uint32_t vertex,
                float time) {
  return end.empty() ? start[vertex] : start[vertex] * (1 - time) + end[vertex] * time;
}

// The inverse transpose up to a factor: its columns are the cross products of those of the map, divided by
// the determinant, of which the sign counts. Without their size the products stay within floats.
Affine scaled_inverse_transpose(const Affine& map) {
  const float size = std::max(
      {largest_magnitude(map.axes[0]), largest_magnitude(map.axes[1]), largest_magnitude(map.axes[2])});
  const std::array axes{map.axes[0] / size, map.axes[1] / size, map.axes[2] / size};
  Affine out;
  out.axes = {cross(axes[1], axes[2]), cross(axes[2], axes[0]), cross(axes[0], axes[1])};
  if (dot(axes[0], out.axes[0]) < 0)
    for (Vec3f& axis : out.axes) axis = -axis;
  return out;
}

Vec3f largest_magnitudes(Vec3f a, Vec3f b) {
  return {std::max(std::abs(a.x), std::abs(b.x)), std::max(std::abs(a.y), std::abs(b.y)),
          std::max(std::abs(a.z), std::abs(b.z))};
}

// Bound of what is added up for a coordinate of a corner, at any time.
float size_of_sums(const RenderObject& object, const TriangleMesh& mesh, std::uint32_t vertex) {
  const Vec3f start = mesh.positions[vertex];
  const Vec3f p = largest_magnitudes(start, mesh.end_positions.empty() ? start : mesh.end_positions[vertex]);
  const auto& a = object.to_world;
  const auto& b = object.end_to_world;
  return largest_magnitude(
      largest_magnitudes(a.axes[0], b.axes[0]) * p.x + largest_magnitudes(a.axes[1], b.axes[1]) * p.y +
      largest_magnitudes(a.axes[2], b.axes[2]) * p.z + largest_magnitudes(a.offset, b.offset));
}

// In half ulps of these sums: the 20 of an instance at rest (surface.cpp), and 3 for each interpolation, of
// the matrix and of the vertex, here and in Embree.
constexpr float kMovingRounding = 32 * 0x1p-24F;

}  // namespace

SurfacePoint point_on_moving_mesh(const RenderObject& object,
                                  const TriangleMesh& mesh,
                                  const Ray& ray,
                                  const Hit& hit) {
  const auto& vertices = mesh.triangles[hit.primitive];
  const Affine to_world = between(object.to_world, object.end_to_world, ray.time);
  const Affine normal_to_world = scaled_inverse_transpose(to_world);
  const std::array weights{1 - hit.barycentric.x - hit.barycentric.y, hit.barycentric.x, hit.barycentric.y};
  std::array<Vec3f, 3> corners;
  Vec3f normal{};
  SurfacePoint out;
  for (std::size_t k = 0; k < 3; ++k) {
    corners[k] =
        apply_to_point(to_world, vertex_at(mesh.positions, mesh.end_positions, vertices[k], ray.time));
    const Vec3f of_vertex =
        apply_to_direction(normal_to_world, vertex_at(mesh.normals, mesh.end_normals, vertices[k], ray.time));
    normal = normal + unit_or(of_vertex, {}) * weights[k];
    out.position_error =
        std::max(out.position_error, kMovingRounding * size_of_sums(object, mesh, vertices[k]));
  }
  const Vec3f edge1 = corners[1] - corners[0];
  const Vec3f edge2 = corners[2] - corners[0];
  out.material = nth(object.material_of, mesh.materials[hit.primitive]);
  out.position = corners[0] + edge1 * hit.barycentric.x + edge2 * hit.barycentric.y;
  // Zero for a triangle that is degenerate at this time: no side agrees with it, and the path ends.
  out.geometric_normal = unit_or(cross(edge1, edge2), {});
  out.shading_normal = unit_or(normal, out.geometric_normal);
  return out;
}

}  // namespace orbs::tracer
