#pragma once

#include "tracer/shapes/solid.h"

#include <embree3/rtcore.h>

namespace orbs::tracer {

/// A shape as a user geometry of Embree; hits have what intersect() in solid_hit.h says. `solid` must outlive
/// the geometry and must not move.
RTCGeometry make_solid_geometry(RTCDevice device, const Solid& solid);

}  // namespace orbs::tracer
