#pragma once

#include "scene/geometry/mesh.h"

namespace orbs::scene {

struct SphereParameters {
  double radius_m = 1;
  int segments = 64;  // around the equator; half as many bands from pole to pole
};
struct TorusParameters {
  double minor_radius_m = 0.25;  // of the tube
  double major_radius_m = 1;     // of the ring that the tube follows
  int ring_segments = 64;
  int tube_segments = 32;
};

constexpr std::size_t triangle_count(const SphereParameters& p) {
  const auto segments = static_cast<std::size_t>(p.segments);
  return segments * segments;
}
constexpr std::size_t triangle_count(const TorusParameters& p) {
  return 2 * static_cast<std::size_t>(p.ring_segments) * static_cast<std::size_t>(p.tube_segments);
}

/// segments^2 triangles, band after band from the north pole (+Y), so the first half is the northern
/// hemisphere; in the two polar bands every second triangle has no area. With i bands from the pole and j
/// segments from +Z towards +X: u = j / segments and v = (1 - i) / (segments - 1), which runs from just above
/// 0 to about -1/2. InputError when `segments` is odd.
Mesh make_sphere(const SphereParameters& parameters);

/// Ring in the XY plane, axis Z; 2 ring_segments tube_segments triangles ordered along the ring from +X
/// towards +Y. u runs around the tube, v along the ring.
Mesh make_torus(const TorusParameters& parameters);

}  // namespace orbs::scene
