#pragma once

#include "tracer/world/world.h"

namespace orbs::tracer {

/// Renders small trial images with and without connections to light vertices, and sets
/// world.connects_light_vertices if they reduce noise by more than their time costs: where most light enters
/// by way of a wall that camera paths rarely hit. The decision is deterministic. `threads` as in
/// RenderSettings. Returns true if it is set; always false if the world does not support them.
bool choose_light_connections(World& world, int threads = 0);

}  // namespace orbs::tracer
