#pragma once

#include "tracer/colour/scene_colours.h"
#include "tracer/world/world.h"

/// A step of make_world.
namespace orbs::tracer {

void add_materials(const scene::Scene& scene, const SceneColours& colours, World& world);

}  // namespace orbs::tracer
