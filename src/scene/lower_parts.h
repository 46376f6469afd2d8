#pragma once

#include "scene/lower.h"

#include <optional>
#include <set>

/// The steps of lower(), and what they share with features_called_for.
namespace orbs::scene {

/// Indices of the materials that an instance or a shape shows, remap lists applied.
std::set<int> visible_materials(const Scene& scene);
/// What each material that an instance shows calls for; one material may call for several things.
std::vector<CalledFeature> features_of_materials(const Scene& scene);
std::vector<CalledFeature> features_of_lights(const Scene& scene);
/// E2 to E6 where the scene calls for the effect that they name, E1 for lights that reflect.
std::vector<CalledFeature> features_of_effects(const Scene& scene);

/// Colours alone, in place, for a scene that does not call for Effect::Spectral.
void drop_spectra(Scene& scene);
/// Each sphere becomes an instance of a tessellated one with exact normals, in place.
void tessellate_spheres(Scene& scene);

/// Oren-Nayar of roughness 0 becomes Lambert, in place.
void replace_smooth_oren_nayar(Scene& scene);
/// Smooth dielectrics without a film that refract all wavelengths alike become ORB.S's Glass, which is the
/// same interface, in place.
void replace_plain_dielectrics(Scene& scene);
/// Applies each texture matrix to the coordinates of the triangles that show it, in place; resolves remap
/// lists for it.
void bake_texture_matrices(Scene& scene);

/// Gives each (mesh, remap list) pair a mesh of its own with the list applied; instances keep no list.
void resolve_remap_lists(Scene& scene);
/// Resolves remap lists and gives each material of a mesh a mesh of its own.
void split_by_material(Scene& scene);
/// Puts all instances into one mesh in world space.
void merge_into_world_mesh(Scene& scene);

/// A light with a translation alone that looks the same; nothing when there is none.
std::optional<Light> without_matrix(const Light& light);
/// The factor by which the matrix scales equally in all directions; nothing when it shears or scales
/// unevenly.
std::optional<double> uniform_scale(const Mat4& matrix);

}  // namespace orbs::scene
