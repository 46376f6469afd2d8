#pragma once

#include "scene/geometry/mesh.h"

namespace orbs::scene {

struct TeapotParameters {
  int subdivisions = 20;  // of each patch, in both directions
};

constexpr std::size_t triangle_count(const TeapotParameters& p) {
  const auto subdivisions = static_cast<std::size_t>(p.subdivisions);
  return 64 * subdivisions * subdivisions;
}

/// The Utah teapot, spout along +X, 64 subdivisions^2 triangles: rim, body, lid and bottom (24 patches),
/// handle (4), spout (4). Uniformly scaled into x [-0.95239, 1.09017], y [-0.40505, 0.59507], z [-0.63493,
/// 0.63493]. Normals are those of the Bezier patches, by their limit at the knob's top and the bottom's
/// centre, where some triangles have no area. u and v are the parameters of each patch.
Mesh make_teapot(const TeapotParameters& parameters);

}  // namespace orbs::scene
