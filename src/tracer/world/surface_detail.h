#pragma once

#include "tracer/geometry/ray.h"
#include "tracer/geometry/surface_point.h"

namespace orbs::tracer {

struct World;

/// Turns the shading normal as the normal or bump map of the material at the point says, if it has one.
void turn_normal(const World& world, const Hit& hit, SurfacePoint& point);

}  // namespace orbs::tracer
