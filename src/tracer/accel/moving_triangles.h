#pragma once

#include "tracer/accel/double_triangles.h"

#include <array>
#include <optional>
#include <vector>

namespace orbs::tracer {

/// A triangle whose corners move within the frame: on Bezier curves of second degree in time, because both
/// the matrix of an instance and the vertices of its mesh may be linear in it.
struct MovingTriangle {
  std::array<DoubleTriangle, 3> control;
};

/// The triangles of a mesh that moves or changes its shape, in world space.
std::vector<MovingTriangle> moving_triangles(const RenderObject& object, const TriangleMesh& mesh);

/// For make_user_geometry: the bounds are those of the whole frame, hits are at the time of the ray.
UserBounds bounds_of(const MovingTriangle& triangle);
std::optional<Hit> hit_of(const MovingTriangle& triangle, unsigned int index, const UserRay& ray);

}  // namespace orbs::tracer
