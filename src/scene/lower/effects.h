#pragma once

#include "scene/scene.h"

namespace orbs::scene {

/// Leaves colours alone, in place, in a scene that does not call for Effect::Spectral.
void drop_spectra(Scene& scene);

}  // namespace orbs::scene
