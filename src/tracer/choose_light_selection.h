#pragma once

#include "tracer/world/world.h"

namespace orbs::tracer {

/// Renders small trial images with emitters selected by the light BVH and by power alone, and empties
/// world.light_bvh if it does not reduce noise by more than its time costs: between bright objects that light
/// most of a scene alike, power is as good. The decision is deterministic. `threads` as in RenderSettings.
/// Returns true if the BVH is kept.
bool choose_light_selection(World& world, int threads = 0);

}  // namespace orbs::tracer
