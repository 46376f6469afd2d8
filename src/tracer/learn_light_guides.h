#pragma once

#include "tracer/render/rendering.h"
#include "tracer/world/world.h"

namespace orbs::tracer {

/// Learns World::light_guides: trial light paths, of which each is connected to two of a few points that the
/// camera sees. They are 5 % as many as the camera paths of a render with these settings, within bounds, and
/// their random numbers are always the same: what is learned depends neither on the seed nor on clock or
/// threads. There are no guides afterwards where too little was found. The world must have emitters.
RenderTime learn_light_guides(World& world, const RenderSettings& settings);

}  // namespace orbs::tracer
