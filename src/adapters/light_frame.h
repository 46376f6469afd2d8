#pragma once

#include "base/matrix.h"

namespace orbs::adapters {

/// Where a light's matrix puts its local axes; flat lights lie in local XZ and shine towards local -Y.
struct LightFrame {
  Vec3d centre;
  Vec3d u;       // image of local X
  Vec3d v;       // image of local Z; of -Z where a mirroring matrix would make (u, v, facing) left-handed
  Vec3d facing;  // unit; perpendicular to u and v, on the side that local -Y goes to
  double area_scale = 1;  // of areas in the local XZ plane
};

LightFrame light_frame(const Mat4& matrix);

/// Takes x to `x`, y to `y` and z to where the light shines, from the origin to its centre.
Mat4 flat_light_matrix(const LightFrame& frame, Vec3d x, Vec3d y);

/// A disk stays a disk: u and v are perpendicular and of one length.
bool is_round(const LightFrame& frame);

}  // namespace orbs::adapters
