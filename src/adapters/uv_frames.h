#pragma once

#include "scene/geometry/mesh.h"

#include <optional>

/// How texture coordinates lie on triangles, for renderers whose frames know less of it than ours.
namespace orbs::adapters {

/// How a point moves with u and v, in metres of the mesh, and the unit normal: the mean of the vertices'.
struct UvFrame {
  Vec3d per_u;
  Vec3d per_v;
  Vec3d normal;
};

/// Nothing where the coordinates are all on one line.
std::optional<UvFrame> uv_frame(const scene::Mesh& mesh, std::size_t triangle);

/// Whether v grows to the other side than normal x (direction of u).
bool is_mirrored(const UvFrame& frame);

/// Whether v is as long as u everywhere, at a right angle, and grows to the side of normal x (direction of
/// u).
bool has_square_frames(const scene::Mesh& mesh);

}  // namespace orbs::adapters
