#pragma once

#include "scene/scene.h"

/// The steps of lower() that change materials, all in place.
namespace orbs::scene {

/// Oren-Nayar of roughness 0 becomes Lambert.
void replace_smooth_oren_nayar(Scene& scene);
/// Smooth dielectrics without a film that refract all wavelengths alike become ORB.S's Glass, which is the
/// same boundary.
void replace_plain_dielectrics(Scene& scene);
/// Applies each texture matrix to the coordinates of the triangles that show it; resolves remap lists for it.
void bake_texture_matrices(Scene& scene);

}  // namespace orbs::scene
