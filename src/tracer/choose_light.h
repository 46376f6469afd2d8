#pragma once

#include "tracer/world/world.h"

namespace orbs::tracer {

/// Renders small trial images with emitters selected by the light BVH and by power alone, and empties
/// world.light_bvh if it does not reduce noise by more than its time costs: between bright objects that light
/// most of a scene alike, power is as good. The decision is deterministic. `threads` as in RenderSettings.
/// Returns true if the BVH is kept.
bool choose_light_selection(World& world, int threads = 0);

/// Renders small trial images with and without light paths, and empties world.caustic_casters if light paths
/// do not reduce noise by more than their time costs: camera paths find a large light in a large flat mirror
/// better. The decision is deterministic. `threads` as in RenderSettings. Returns true if light paths are
/// kept.
bool choose_light_paths(World& world, int threads = 0);

/// Renders small trial images with and without connections to light vertices, and sets
/// world.connects_light_vertices if they reduce noise by more than their time costs: where most light enters
/// by way of a wall that camera paths rarely hit. The decision is deterministic. `threads` as in
/// RenderSettings. Returns true if it is set; always false if the world does not support them.
bool choose_light_connections(World& world, int threads = 0);

}  // namespace orbs::tracer
