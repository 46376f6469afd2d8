#pragma once

#include "tracer/light/bounding_sphere.h"
#include "tracer/light/emitter.h"

#include <vector>

/// Where light paths start at lights without an area.
namespace orbs::tracer {

struct StartWithoutArea {
  Vec3f position;
  Vec3f direction;  // unit
  float pdf = 0;    // of a point per solid angle; of parallel light per m^2 across it
};

/// Towards one of the casters, each with equal probability. `pick`, u and v in [0, 1); `casters` must not be
/// empty, and the light must have no area.
StartWithoutArea start_towards_casters(
    const AreaLight& light, const std::vector<BoundingSphere>& casters, float pick, float u, float v);

}  // namespace orbs::tracer
