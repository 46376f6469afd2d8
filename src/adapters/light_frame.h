#pragma once

#include "base/matrix.h"

namespace orbs::adapters {

/// The image of a light's local axes under its matrix; flat lights lie in local XZ and shine towards local
/// -Y.
struct LightFrame {
  Vec3d centre;
  Vec3d u;       // image of local X
  Vec3d v;       // image of local Z; of -Z where a mirroring matrix would make (u, v, facing) left-handed
  Vec3d facing;  // unit; perpendicular to u and v, on the side that local -Y goes to
  double area_scale = 1;  // of areas in the local XZ plane
};

LightFrame light_frame(const Mat4& matrix);

/// A matrix that takes x to `x`, y to `y`, z to the direction in which the light shines, and the origin to
/// its centre.
Mat4 flat_light_matrix(const LightFrame& frame, Vec3d x, Vec3d y);

/// Whether a disk stays a disk: u and v are perpendicular and of one length.
bool is_round(const LightFrame& frame);

}  // namespace orbs::adapters
