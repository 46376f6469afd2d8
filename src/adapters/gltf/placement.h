#pragma once

#include "base/matrix.h"

#include <array>
#include <optional>

namespace orbs::adapters::gltf {

/// A node's transform as glTF splits it: scale, then rotation, then translation. `rotation` is a unit
/// quaternion (x, y, z, w).
struct Placement {
  Vec3d translation;
  std::array<double, 4> rotation{0, 0, 0, 1};
  Vec3d scale{1, 1, 1};
};

/// The matrix as a placement; nothing when its axes are not at right angles, which no glTF node may have.
/// What mirrors has a negative scale along x.
std::optional<Placement> placement_of(const Mat4& matrix);

/// KHR_texture_transform. It scales, turns and moves the coordinates (u, v) of glTF, where v is 0 in the top
/// row.
struct TextureTransform {
  std::array<double, 2> offset{0, 0};
  double rotation_rad = 0;
  std::array<double, 2> scale{1, 1};
};

/// What a texture matrix of ORB.S, whose v is 0 in the bottom row, does to coordinates (u, 1 - v); nothing
/// when its axes are not at right angles.
std::optional<TextureTransform> texture_transform_of(const Mat4& matrix);

}  // namespace orbs::adapters::gltf
