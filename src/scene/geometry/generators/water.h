#pragma once

#include "scene/geometry/mesh.h"

namespace orbs::scene {

struct WaterParameters {
  double half_width_m = 1;   // along x
  double half_length_m = 1;  // along z
  double depth_m = 1;        // from the mean surface, y = 0, down to the flat bottom
  double amplitude_m = 0.05;
  double wavelength_m = 1;  // of the longest wave
  int segments = 64;        // of the surface, in both directions
};

constexpr std::size_t triangle_count(const WaterParameters& p) {
  const auto segments = static_cast<std::size_t>(p.segments);
  return 2 * segments * segments + 12 * segments;
}

/// A closed box of water whose top is wavy: three sine waves that together stay within +-amplitude about y =
/// 0. Normals of the top are those of the exact waves. 2 segments^2 triangles of the top, then 8 segments of
/// the sides, then 4 segments of the bottom. u along x and v along z in [0, 1].
Mesh make_water(const WaterParameters& parameters);

}  // namespace orbs::scene
