#pragma once

#include "tracer/geometry/lanes.h"

namespace orbs::tracer {

/// Right-handed orthonormal basis whose z axis is the surface normal.
template <typename V>
struct FrameOf {
  V x;
  V y;
  V z;

  V to_local(V v) const { return {dot(v, x), dot(v, y), dot(v, z)}; }
  V to_world(V v) const { return x * v.x + y * v.y + z * v.z; }
};

using Frame = FrameOf<Vec3f>;

/// Frame around a unit normal, without branches and without a singularity (Duff et al. 2017, "Building an
/// Orthonormal Basis, Revisited", listing 3).
template <typename V>
FrameOf<V> frame_around(V n) {
  using Real = decltype(n.x);
  const Real one = Real{} + 1.0F;
  const Real sign = with_sign_of(one, n.z);
  const Real a = -1.0F / (sign + n.z);
  const Real b = n.x * n.y * a;
  return {{1.0F + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

}  // namespace orbs::tracer
