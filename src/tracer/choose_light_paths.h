#pragma once

#include "tracer/world.h"

namespace orbs::tracer {

/// Tries light paths on a small image and empties world.light_path_targets where they are not worth their
/// time: a broad light by way of a large flat mirror is better found from the camera. Always decides alike
/// for the same world. `threads` as in RenderSettings. Returns the decision.
bool choose_light_paths(World& world, int threads = 0);

}  // namespace orbs::tracer
