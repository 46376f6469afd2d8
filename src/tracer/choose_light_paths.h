#pragma once

#include "tracer/world/world.h"

namespace orbs::tracer {

/// Renders small trial images with and without light paths, and empties world.caustic_casters if light paths
/// do not reduce noise by more than their time costs: camera paths find a large light in a large flat mirror
/// better. The decision is deterministic. `threads` as in RenderSettings. Returns true if light paths are
/// kept.
bool choose_light_paths(World& world, int threads = 0);

}  // namespace orbs::tracer
