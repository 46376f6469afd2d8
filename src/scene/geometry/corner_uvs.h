#pragma once

#include "scene/geometry/mesh.h"

#include <optional>
#include <vector>

namespace orbs::scene {

/// Texture coordinates of the corners of faces, where they differ from those of their vertices. Corners
/// beyond the end have none.
using CornerUvs = std::vector<std::optional<Vec2f>>;

/// Gives each vertex the texture coordinates of its corners; where these differ, the vertex becomes several.
/// `corners` are the vertices of all faces, which are all in range, and `places` where the vertices lie; the
/// mesh has all else.
void split_by_uvs(const CornerUvs& uvs,
                  std::vector<std::uint32_t>& corners,
                  std::vector<Vec3d>& places,
                  Mesh& mesh);

}  // namespace orbs::scene
