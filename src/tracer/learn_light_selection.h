#pragma once

#include "tracer/render/rendering.h"
#include "tracer/world/world.h"

namespace orbs::tracer {

/// Lets a light BVH of the world's emitters learn what is blocked: at the first few surfaces that camera
/// paths meet, each sends one light sample, selected by the tree as it is. They are 2 % of the camera paths
/// of a render with these settings, within bounds, in one pass, and their random numbers are always the same:
/// what is learned depends neither on the seed nor on clock or threads. Nothing is learned, and no time
/// taken, without a tree or for images of a few thousand paths. The world is as before afterwards.
RenderTime learn_light_selection(LightBvh& tree, World& world, const RenderSettings& settings);

}  // namespace orbs::tracer
