#pragma once

#include "tracer/colour/scene_colours.h"
#include "tracer/world/world.h"

/// Steps of make_world.
namespace orbs::tracer {

/// Adds the lights, in coordinates relative to `origin`. `is_vast`: as in add_meshes, of each light.
void add_lights(const scene::Scene& scene,
                Vec3d origin,
                const SceneColours& colours,
                const std::vector<bool>& is_vast,
                World& world);

/// Fills world.emitters from lights and emissive triangles, once materials, meshes and lights are there, and
/// world.light_bvh if it is to select them.
void build_emitters(World& world, LightSelection selection);

}  // namespace orbs::tracer
