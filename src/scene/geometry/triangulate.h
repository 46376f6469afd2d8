#pragma once

#include "base/vec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace orbs::scene {

/// The triangles of a polygon, by places in the list of its corners.
struct Triangulation {
  std::vector<std::array<std::uint32_t, 3>> triangles;  // always two fewer than corners
  bool crosses_itself = false;                          // then no triangulation is right, and this is the fan
};

/// Concave polygons of more corners are refused: ear clipping takes quadratic time, three seconds for these.
constexpr std::size_t kMostConcaveCorners = 16384;

/// Triangles that cover a polygon of three or more corners once and are wound as it is.
///
/// Where the fan from the first corner does that (always if the polygon is convex), it is the fan. Else ears
/// are clipped (Meisters 1975) in the plane along the axes that the polygon faces most: corners that lie on a
/// line, corners given twice, and holes that a doubled edge joins to the outline are covered as well, by
/// triangles without area where it must be. A polygon is concave where floats can tell: an overlap of the
/// fan's triangles that is smaller than the rounding of the corners is none. A polygon two of whose edges
/// cross keeps the fan. InputError, without a place, for more than kMostConcaveCorners.
Triangulation triangulate(const std::vector<Vec3d>& corners);

}  // namespace orbs::scene
