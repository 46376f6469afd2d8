#pragma once

#include "tracer/light/emitter.h"
#include "tracer/light/light_bounds.h"

#include <vector>

namespace orbs::tracer {

/// Bounds of all emitters, the lights first, with the powers (radiance times area) of EmitterTable::build.
std::vector<LightBounds> bounds_of(const std::vector<AreaLight>& lights,
                                   const std::vector<TriangleEmitter>& triangles,
                                   const std::vector<float>& powers);

}  // namespace orbs::tracer
