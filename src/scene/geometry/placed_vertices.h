#pragma once

#include "base/vec.h"

#include <vector>

namespace orbs::scene {

/// Vertices of a mesh as floats, relative to an origin.
struct PlacedVertices {
  std::vector<Vec3f> positions;
  Vec3d origin_m;
};

/// Vertices as a file gives them. The origin is zero, and each number is rounded to the nearest float, unless
/// the mesh lies farther out than 64 times its extent: floats would then round away more than 4e-6 of the
/// extent. The origin is then a place in the mesh to which doubles subtract exactly (Sterbenz' lemma for
/// vertices that floats or doubles of the file's size hold).
PlacedVertices placed_vertices(const std::vector<Vec3d>& vertices);

}  // namespace orbs::scene
