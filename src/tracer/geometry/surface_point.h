#pragma once

#include "base/vec.h"

namespace orbs::tracer {

/// A point on a surface. All vectors are in world space.
struct SurfacePoint {
  Vec3f position;
  /// Bound of the distance between `position` and the surface that Embree intersected, in metres.
  float position_error = 0;
  Vec3f geometric_normal;  // unit, on either side
  Vec3f shading_normal;    // unit, interpolated as given, not flipped to the viewer
  int material = 0;
};

}  // namespace orbs::tracer
