#pragma once

#include "tracer/world/world.h"

#include <vector>

namespace orbs::tracer {

/// One sphere around the near-specular triangles of each object, or a single one around all if there would be
/// many, because each costs time per light path.
std::vector<BoundingSphere> find_caustic_casters(const World& world);

}  // namespace orbs::tracer
