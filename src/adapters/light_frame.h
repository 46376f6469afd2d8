#pragma once

#include "base/matrix.h"

#include <cmath>

namespace orbs::adapters {

/// The image of a light's local axes under its matrix; flat lights lie in local XZ and shine towards local
/// -Y.
struct LightFrame {
  Vec3d centre;
  Vec3d u;       // image of local X
  Vec3d v;       // image of local Z; of -Z where a mirroring matrix would make (u, v, facing) left-handed
  Vec3d facing;  // unit; perpendicular to u and v, on the side that local -Y goes to
  double area_scale = 1;  // of areas in the local XZ plane
};

// The normal follows the inverse transpose, which leaves it perpendicular to the images of both edges.
inline LightFrame light_frame(const Mat4& matrix) {
  const Vec3d u = transform_direction(matrix, {1, 0, 0});
  const Vec3d v = transform_direction(matrix, {0, 0, 1});
  const Vec3d down = transform_direction(matrix, {0, -1, 0});
  const Vec3d across = cross(u, v);
  const double hand = dot(across, down) < 0 ? -1.0 : 1.0;
  return {transform_point(matrix, {}), u, v * hand, normalised(across) * hand, length(across)};
}

/// Where a light without an area shines to: the image of local -Y, unit. No surface could be sheared.
inline Vec3d shining_direction(const Mat4& matrix) {
  return normalised(transform_direction(matrix, {0, -1, 0}));
}

/// A matrix that takes x to `x`, y to `y`, z to the direction in which the light shines, and the origin to
/// its centre.
inline Mat4 flat_light_matrix(const LightFrame& frame, Vec3d x, Vec3d y) {
  const Vec3d z = frame.facing;
  const Vec3d o = frame.centre;
  return {{x.x, y.x, z.x, o.x, x.y, y.y, z.y, o.y, x.z, y.z, z.z, o.z, 0, 0, 0, 1}};
}

/// Whether a disk stays a disk: u and v are perpendicular and of one length.
inline bool is_round(const LightFrame& frame) {
  // Rounding of a rotation and a uniform scale stays far below this; a scale that is meant to be uneven does
  // not.
  constexpr double kRounding = 1e-6;
  const double square = dot(frame.u, frame.u);
  return std::abs(dot(frame.v, frame.v) - square) <= kRounding * square &&
         std::abs(dot(frame.u, frame.v)) <= kRounding * square;
}

}  // namespace orbs::adapters
