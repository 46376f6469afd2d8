#pragma once

#include "scene/effects/features.h"
#include "scene/scene.h"

#include <set>
#include <string>
#include <variant>

/// The steps of lower() that change materials, all in place.

namespace orbs::scene {

/// Leaves colours alone, in place, in a scene that does not call for Effect::Spectral.
void drop_spectra(Scene& scene);

/// Oren-Nayar of roughness 0 becomes Lambert.
void replace_smooth_oren_nayar(Scene& scene);
/// Smooth dielectrics without a film that refract all wavelengths alike become ORB.S's Glass, which is the
/// same boundary.
void replace_plain_dielectrics(Scene& scene);
/// Applies each texture matrix to the coordinates of the triangles that show it; resolves remap lists for it.
void bake_texture_matrices(Scene& scene);
/// The complaint about a material whose textures have different matrices: no coordinates can be made of
/// these. "" where they agree.
std::string texture_matrices_problem(const Scene& scene, int material);

/// Requirement codes ("G3", "M5") that a renderer fulfils.
using Capabilities = std::set<std::string>;

/// ORB.S section 1, note: where a renderer lacks a level, the exporter prepares the data as that level
/// prescribes, or says why it cannot. Either the scene in a form that calls for nothing beyond
/// `capabilities`, or the reason, one reason.
///   without G3  one mesh in world space, several materials; meshes that are not instanced are left out
///   without G4  instances; remap lists are resolved into further meshes
///   without G5  as above, and each mesh has exactly one material
///   without M5  texture matrices are applied to the texture coordinates
///   without M7  Oren-Nayar of roughness 0, which is Lambert's law, becomes it
///   without E1  smooth dielectrics that refract all wavelengths alike become glass
///   without S1  spheres, other quadrics and boxes become meshes
///   without S2  tori and superellipsoids become meshes
///   without S5  subdivision surfaces become meshes
///   without S6  displaced subdivision surfaces become meshes
///   without E2  spectra that their colours can stand for are left out
///   without L3  lights that are only moved and scaled get the scale in their sizes
/// What is drawn stays the same, up to the rounding of coordinates to float.
std::variant<Scene, std::string> lower(const Scene& scene, const Capabilities& capabilities);

}  // namespace orbs::scene
