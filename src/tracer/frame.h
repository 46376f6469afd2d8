#pragma once

#include "base/vec.h"

#include <cmath>

namespace orbs::tracer {

/// Right-handed orthonormal basis whose z axis is the surface normal.
struct Frame {
  Vec3f x;
  Vec3f y;
  Vec3f z;

  Vec3f to_local(Vec3f v) const { return {dot(v, x), dot(v, y), dot(v, z)}; }
  Vec3f to_world(Vec3f v) const { return x * v.x + y * v.y + z * v.z; }
};

/// Duff et al. 2017, "Building an Orthonormal Basis, Revisited", listing 3: no branch, and no pole where
/// digits get lost.
inline Frame frame_around(Vec3f n) {
  const float sign = std::copysign(1.0F, n.z);
  const float a = -1.0F / (sign + n.z);
  const float b = n.x * n.y * a;
  return {{1.0F + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

}  // namespace orbs::tracer
