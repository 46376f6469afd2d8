#pragma once

#include "tracer/world/world.h"

namespace orbs::tracer {

/// Tries light paths on a small image and empties world.caustic_casters where they are not worth their
/// time: a broad light by way of a large flat mirror is better found from the camera. Always decides alike
/// for the same world. `threads` as in RenderSettings. Returns the decision.
bool choose_light_paths(World& world, int threads = 0);

}  // namespace orbs::tracer
