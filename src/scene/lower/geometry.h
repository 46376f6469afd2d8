#pragma once

#include "scene/scene.h"

/// The steps of lower() that change meshes and instances, all in place.
namespace orbs::scene {

/// Each sphere becomes an instance of a tessellated one with exact normals.
void tessellate_spheres(Scene& scene);
/// Replaces the shapes of this level ("S1" or "S2") that have a mesh by it.
void tessellate_shapes(Scene& scene, const char* level);
/// Gives each (mesh, remap list) pair its own mesh with the list applied; instances keep no list.
void resolve_remap_lists(Scene& scene);
/// Resolves remap lists and gives each material of a mesh its own mesh.
void split_by_material(Scene& scene);
/// Puts all instances into one mesh in world space.
void merge_into_world_mesh(Scene& scene);

}  // namespace orbs::scene
