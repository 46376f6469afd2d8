#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

/// Which requirements a scene calls for, and why.
namespace orbs::scene {

/// A requirement that a scene calls for, and the object in it that does.
struct CalledFeature {
  std::string requirement;
  std::string what;  // "material 'a' is rough glass"
};

/// What a renderer must fulfil to draw the scene as it is, each requirement once, ordered by code. Materials
/// that no instance shows call for nothing. Glossy reflection calls for A2 and rough glass for A4: no M level
/// defines them, these levels test them. Our own groups: E1 conductors, and rough dielectrics, by their
/// indices, and lights that reflect (a smooth dielectric is the smooth glass of M8), E2 spectra, E3
/// polarisation, E4 fluorescence, E5 thin films, E6 dispersion; S1 quadrics by formula, S2 tori and
/// superellipsoids, S3 implicit surfaces, S4 solids by CSG, S5 subdivision surfaces, S6 their displacement,
/// S7 shapes of plug-ins; T1 instances that move, T2 meshes that change their shape, T3 a camera that moves;
/// I1 ambient occlusion, I2 irradiance caches; N1 normal maps, N2 bump maps, N3 surfaces that let rays pass,
/// N4 mirrored textures, N5 textures that are not interpolated; C1 a lens, C2 an orthographic camera, C3 a
/// shifted lens, C4 a latitude-longitude image; D5 an environment map, D6 an
/// environment that the camera does not see; V1 layers of the surface that the camera sees.
std::vector<CalledFeature> features_called_for(const Scene& scene);

/// The parts of features_called_for; one object may call for several requirements, and one requirement may be
/// called for by several objects.
std::vector<CalledFeature> features_of_geometry(const Scene& scene);
/// The part of features_of_geometry that shapes by their formula call for.
std::vector<CalledFeature> features_of_shapes(const Scene& scene);
/// The part of features_of_geometry that subdivision surfaces call for.
std::vector<CalledFeature> features_of_subdivision(const Scene& scene);
std::vector<CalledFeature> features_of_materials(const Scene& scene);
std::vector<CalledFeature> features_of_lights(const Scene& scene);
std::vector<CalledFeature> features_of_environment(const Scene& scene);
std::vector<CalledFeature> features_of_motion(const Scene& scene);
std::vector<CalledFeature> features_of_camera(const Scene& scene);
std::vector<CalledFeature> features_of_integrator(const Scene& scene);
std::vector<CalledFeature> features_of_outputs(const Scene& scene);
/// E2 to E6 where the scene calls for the effect that they name, E1 for lights that reflect.
std::vector<CalledFeature> features_of_effects(const Scene& scene);

}  // namespace orbs::scene
