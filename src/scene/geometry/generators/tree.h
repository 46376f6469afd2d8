#pragma once

#include "scene/geometry/mesh.h"

namespace orbs::scene {

struct TreeParameters {
  double height_m = 4;
  double radius_m = 1.2;  // of the lowest branches
  int tiers = 6;          // cones of branches, one above the other
  int points = 10;        // tips of the star that each tier is from above
};

/// Triangles of the trunk, which come first; the rest is foliage.
inline constexpr int kTreeTrunkTriangles = 16;

constexpr std::size_t triangle_count(const TreeParameters& p) {
  return kTreeTrunkTriangles + 4 * static_cast<std::size_t>(p.tiers) * static_cast<std::size_t>(p.points);
}

/// A fir with its foot in the origin: an open trunk, then from bottom to top `tiers` closed cones of 4 points
/// triangles each. Facets are flat: triangles share no vertices. u runs around the trunk or cone, v
/// upwards, both in [0, 1].
Mesh make_tree(const TreeParameters& parameters);

}  // namespace orbs::scene
