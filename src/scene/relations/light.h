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

/// Each colour (r, g, b) as (g, b, r). The reason if a surface, a light or a texture is more than a colour of
/// three channels.
std::variant<Scene, std::string> with_rotated_channels(const Scene& scene);

}  // namespace orbs::scene
