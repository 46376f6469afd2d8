#pragma once

#include "scene/scene.h"
#include "tracer/world/world.h"

/// Steps of make_world.
namespace orbs::tracer {

/// The matrix in coordinates whose zero is `origin`.
Mat4 relative_to(Mat4 matrix, Vec3d origin);

/// Adds meshes and their instances to the world, in coordinates relative to `origin`. `most_copied_triangles`
/// as in WorldSettings. `is_vast`: of each instance, whether floats are too coarse for its corners.
void add_meshes(const scene::Scene& scene,
                Vec3d origin,
                const std::vector<bool>& is_vast,
                std::size_t most_copied_triangles,
                World& world);

void add_spheres(const scene::Scene& scene, Vec3d origin, World& world);
/// Shapes by their formula but for spheres.
void add_solids(const scene::Scene& scene, Vec3d origin, World& world);
void add_plugin_shapes(const scene::Scene& scene,
                       Vec3d origin,
                       const PluginLibraries& libraries,
                       World& world);

}  // namespace orbs::tracer
