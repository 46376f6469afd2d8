#pragma once

#include "base/vec.h"

#include <cstdint>
#include <vector>

namespace orbs::scene {

/// A point of quadrilaterals that no finite sharpness has any more, and what surrounds it, counter-clockwise
/// seen from outside. Face i lies between edges i and i + 1; where the surface ends at the point there is one
/// edge more than faces, else the last face ends at the first edge.
struct VertexRing {
  Vec3d point_m;
  std::vector<Vec3d> edge_ends_m;
  std::vector<Vec3d> opposite_m;  // the point of each face that is no neighbour
  std::vector<bool> is_sharp;     // by edge; the first one is, if any is
  bool is_corner = false;
};

/// Where the point of the limit surface lies, and its normals.
struct RingLimit {
  Vec3d point_m;
  /// Unit normals, one for each sector: the faces from one sharp edge to the next, or all. Zero where the
  /// neighbours lie so that there is none.
  std::vector<Vec3d> normals;
  std::vector<std::uint32_t> sector;  // by face
};

/// In closed form, by the left eigenvectors of the step (Halstead, Kass, DeRose 1993, Efficient, Fair
/// Interpolation using Catmull-Clark Surfaces, appendix A; Biermann, Levin, Zorin 2000, Piecewise Smooth
/// Subdivision Surfaces with Normal Control, table of the masks of creases). Darts, where a crease ends, have
/// no closed form; there the steps themselves are taken, until the ring is smaller than a double's last
/// digit.
///
/// Within a corner's sector of two or more faces the scheme has no tangent plane in general; its normal is
/// the sum of those of its faces, weighted by their areas. The same holds at corners without sharp edges.
RingLimit limit_of(const VertexRing& ring);

/// The limit and the normal of a ring without corners and with at most one sharp edge, by `steps` steps: what
/// darts take, and what the closed forms are tested against.
RingLimit limit_by_steps(const VertexRing& ring, int steps);

}  // namespace orbs::scene
