#pragma once

#include "base/vec.h"

#include <cmath>
#include <vector>

/// Flat mirrors: seen from a point, a light in the mirror is the light seen from the mirrored point.
namespace orbs::tracer {

struct MirrorPlane {
  Vec3f normal;      // unit, to the reflecting side
  float offset = 0;  // dot(normal, point of the plane)
};

inline float height_over(const MirrorPlane& plane, Vec3f point) {
  return dot(plane.normal, point) - plane.offset;
}

/// True if the point is in front of the plane by more than rounding; points of a triangle in the plane are
/// not. This only decides which technique samples the light, so a bound wider than rounding loses nothing.
inline bool is_in_front(const MirrorPlane& plane, Vec3f point) {
  return height_over(plane, point) > 1e-4F * (1 + std::abs(plane.offset));
}

inline Vec3f mirrored(const MirrorPlane& plane, Vec3f point) {
  return point - plane.normal * (2 * height_over(plane, point));
}
inline Vec3f mirrored_direction(const MirrorPlane& plane, Vec3f direction) {
  return direction - plane.normal * (2 * dot(plane.normal, direction));
}

/// Number of planes that have the point in front of them.
inline int count_planes_facing(const std::vector<MirrorPlane>& planes, Vec3f point) {
  int count = 0;
  for (const MirrorPlane& plane : planes) count += is_in_front(plane, point) ? 1 : 0;
  return count;
}

/// Index of the n-th of those planes, n in [0, count_planes_facing); -1 beyond.
inline int plane_facing(const std::vector<MirrorPlane>& planes, Vec3f point, int n) {
  for (std::size_t i = 0; i < planes.size(); ++i)
    if (is_in_front(planes[i], point) && n-- == 0) return static_cast<int>(i);
  return -1;
}

}  // namespace orbs::tracer
