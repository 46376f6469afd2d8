#include "tracer/accel/double_triangles.h"

#include <algorithm>
#include <cmath>

namespace orbs::tracer {

namespace {

using Components = std::array<double, 3>;

Components components(Vec3d v) { return {v.x, v.y, v.z}; }

struct Shear {
  std::array<std::size_t, 3> axes{};  // the last is the direction's largest component
  double x = 0, y = 0, z = 0;
};

Shear shear_along(Vec3d direction) {
  Shear shear;
  const Components d = components(direction);
  const auto* largest = std::max_element(
      d.begin(), d.end(), [](double left, double right) { return std::fabs(left) < std::fabs(right); });
  const auto axis = static_cast<std::size_t>(largest - d.begin());
  shear.axes = {(axis + 1) % 3, (axis + 2) % 3, axis};
  const double along = d[axis];
  shear.x = d[shear.axes[0]] / along;
  shear.y = d[shear.axes[1]] / along;
  shear.z = 1 / along;
  return shear;
}

}  // namespace

Vec3d to_world(const Affine& map, Vec3d p) {
  return cast<double>(map.axes[0]) * p.x + cast<double>(map.axes[1]) * p.y + cast<double>(map.axes[2]) * p.z +
         cast<double>(map.offset);
}

std::optional<TriangleHit> intersect(
    const DoubleTriangle& triangle, Vec3d origin, Vec3d direction, double near, double far) {
  const Shear shear = shear_along(direction);
  std::array<Components, 3> corner{};  // in the space where the ray is the z axis
  for (std::size_t i = 0; i < 3; ++i) {
    const Components p = components(triangle.corners[i] - origin);
    const double along = p[shear.axes[2]];
    corner[i] = {p[shear.axes[0]] - shear.x * along, p[shear.axes[1]] - shear.y * along, shear.z * along};
  }
  const auto& [a, b, c] = corner;
  const double u = c[0] * b[1] - c[1] * b[0];
  const double v = a[0] * c[1] - a[1] * c[0];
  const double w = b[0] * a[1] - b[1] * a[0];
  if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return std::nullopt;
  const double determinant = u + v + w;
  if (determinant == 0) return std::nullopt;  // the triangle is seen edge-on
  const double distance = (u * a[2] + v * b[2] + w * c[2]) / determinant;
  if (!(distance > near && distance < far)) return std::nullopt;
  return TriangleHit{distance, {v / determinant, w / determinant}};
}

std::vector<DoubleTriangle> world_triangles(const RenderObject& object, const TriangleMesh& mesh) {
  std::vector<DoubleTriangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    DoubleTriangle triangle;
    const bool is_degenerate = mesh.triangle_cache[i].geometric_normal == Vec3f{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const auto vertex = mesh.triangles[i][is_degenerate ? 0 : corner];
      const Vec3d position =
          mesh.exact_positions.empty() ? cast<double>(mesh.positions[vertex]) : mesh.exact_positions[vertex];
      triangle.corners[corner] =
          object.kind == ObjectKind::InstancedMesh ? to_world(object.to_world, position) : position;
    }
    triangles.push_back(triangle);
  }
  return triangles;
}

UserBounds bounds_of(const DoubleTriangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  return {{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})},
          {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})}};
}

std::optional<Hit> hit_of(const DoubleTriangle& triangle, unsigned int index, const UserRay& ray) {
  const auto found =
      intersect(triangle, cast<double>(ray.origin), cast<double>(ray.direction), ray.near, ray.far);
  if (!found) return std::nullopt;
  Hit hit;
  hit.distance = static_cast<float>(found->distance);
  hit.barycentric = {static_cast<float>(found->uv[0]), static_cast<float>(found->uv[1])};
  hit.primitive = index;
  return hit;
}

}  // namespace orbs::tracer
