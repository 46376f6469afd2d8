#pragma once

#include "scene/scene.h"

#include <string>
#include <variant>

/// Changes of the light and of colours.
namespace orbs::scene {

/// What the light emits, as a colour and as a spectrum, times `factor`.
void multiply_emission(Light& light, double factor);

/// All emission times `factor`: environment, emissive materials and lights, as colours and as spectra.
Scene with_emission_times(const Scene& scene, double factor);

/// Each point without a profile as two spots of half angles of 90 degrees, back to back: together they shine
/// to all sides as the point does. The reason if there is no such point.
std::variant<Scene, std::string> with_points_as_spots(const Scene& scene);

/// Each point without a profile as a sphere of the same flux: of intensity I over the area pi r^2 that every
/// side sees of it. The radius r is `share` of the distance to the camera, or of the radius of all that is
/// drawn if that is less. The reason if there is no such point, or if the sphere could be seen where the
/// point is not: in the image, in smooth surfaces, or through what lets rays pass.
std::variant<Scene, std::string> with_points_as_spheres(const Scene& scene, double share);

/// Each colour (r, g, b) as (g, b, r). The reason if a surface, a light or a texture is more than a colour of
/// three channels.
std::variant<Scene, std::string> with_rotated_channels(const Scene& scene);

}  // namespace orbs::scene
