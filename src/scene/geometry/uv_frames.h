#pragma once

#include "scene/geometry/mesh.h"

#include <optional>

/// How texture coordinates lie on triangles, for renderers whose frames know less of it than ours.
namespace orbs::scene {

/// How a point moves with u and v, in metres of the mesh, and the unit normal: the mean of the vertices'.
struct UvFrame {
  Vec3d per_u;
  Vec3d per_v;
  Vec3d normal;
};

/// That of the mesh's first or second coordinates. Nothing where they are all on one line.
std::optional<UvFrame> uv_frame(const Mesh& mesh, std::size_t triangle, int uv_set = 0);

/// Whether v grows to the other side than normal x (direction of u).
bool is_mirrored(const UvFrame& frame);

/// The direction of u across a unit normal, of length 1. Nothing where the normal lies along u.
std::optional<Vec3d> tangent_across(const UvFrame& frame, Vec3d normal);

/// Whether v is as long as u everywhere, at a right angle, and grows to the side of normal x (direction of
/// u).
bool has_square_frames(const Mesh& mesh);

}  // namespace orbs::scene
