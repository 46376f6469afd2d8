#include "tracer/accel/moving_triangles.h"

#include <cmath>

namespace orbs::tracer {

std::vector<MovingTriangle> moving_triangles(const RenderObject& object, const TriangleMesh& mesh) {
  const auto& end_positions = mesh.end_positions.empty() ? mesh.positions : mesh.end_positions;
  std::vector<MovingTriangle> triangles(mesh.triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3d start = cast<double>(mesh.positions[mesh.triangles[i][k]]);
      const Vec3d end = cast<double>(end_positions[mesh.triangles[i][k]]);
      auto& [first, middle, last] = triangles[i].control;
      first.corners[k] = to_world(object.to_world, start);
      last.corners[k] = to_world(object.end_to_world, end);
      // (1 - t)^2 M0 v0 + t (1 - t) (M0 v1 + M1 v0) + t^2 M1 v1
      middle.corners[k] = (to_world(object.to_world, end) + to_world(object.end_to_world, start)) * 0.5;
    }
  return triangles;
}

// A Bezier curve does not leave the hull of its control points.
UserBounds bounds_of(const MovingTriangle& triangle) {
  UserBounds out = bounds_of(triangle.control[0]);
  for (const DoubleTriangle& control : triangle.control) {
    const UserBounds one = bounds_of(control);
    out.low = {std::fmin(out.low.x, one.low.x), std::fmin(out.low.y, one.low.y),
               std::fmin(out.low.z, one.low.z)};
    out.high = {std::fmax(out.high.x, one.high.x), std::fmax(out.high.y, one.high.y),
                std::fmax(out.high.z, one.high.z)};
  }
  return out;
}

std::optional<Hit> hit_of(const MovingTriangle& triangle, unsigned int index, const UserRay& ray) {
  const double t = ray.time;
  const auto& [first, middle, last] = triangle.control;
  DoubleTriangle now;
  for (std::size_t k = 0; k < 3; ++k)
    now.corners[k] = first.corners[k] * ((1 - t) * (1 - t)) + middle.corners[k] * (2 * t * (1 - t)) +
                     last.corners[k] * (t * t);
  return hit_of(now, index, ray);
}

}  // namespace orbs::tracer
