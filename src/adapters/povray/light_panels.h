#pragma once

#include "adapters/povray/settings.h"
#include "scene/scene.h"

namespace orbs::adapters::povray {

/// How many panels a rectangular light is cut into along each side, each a separate light source: a power
/// of two, at least settings.area_split, and at most a half of settings.area_grid, so that POV-Ray has four
/// samples of each. POV-Ray takes the cosine at the light for the whole panel from its centre.
int panels_per_side(const scene::Scene& scene, const scene::Light& light, const PovraySettings& settings);

}  // namespace orbs::adapters::povray
