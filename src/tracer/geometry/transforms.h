#pragma once

#include "base/matrix.h"
#include "base/vec.h"
#include "tracer/geometry/lanes.h"

#include <array>
#include <cmath>

namespace orbs::tracer {

/// 3x4 affine map in single precision.
struct Affine {
  std::array<Vec3f, 3> axes{Vec3f{1, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0, 0, 1}};  // images of x, y, z
  Vec3f offset;
};

inline Vec3f apply_to_direction(const Affine& map, Vec3f v) {
  return map.axes[0] * v.x + map.axes[1] * v.y + map.axes[2] * v.z;
}
inline Vec3f apply_to_point(const Affine& map, Vec3f p) { return apply_to_direction(map, p) + map.offset; }

inline Affine affine(const Mat4& m) {
  Affine out;
  for (std::size_t c = 0; c < 3; ++c) out.axes[c] = cast<float>(Vec3d{m(0, c), m(1, c), m(2, c)});
  out.offset = cast<float>(Vec3d{m(0, 3), m(1, 3), m(2, 3)});
  return out;
}

/// Entry by entry, as Embree interpolates the transforms of moving instances.
inline Affine between(const Affine& start, const Affine& end, float time) {
  Affine out;
  for (std::size_t c = 0; c < 3; ++c) out.axes[c] = start.axes[c] * (1 - time) + end.axes[c] * time;
  out.offset = start.offset * (1 - time) + end.offset * time;
  return out;
}

/// The direction of a sum of normals. Opposite ones can cancel in it; another normal then replaces them.
inline Vec3f unit_or(Vec3f normal, Vec3f other) {
  const float squared = dot(normal, normal);
  return squared > 0 ? normal / std::sqrt(squared) : other;
}

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
