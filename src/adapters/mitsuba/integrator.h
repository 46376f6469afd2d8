#pragma once

#include "scene/scene.h"

#include <string>

namespace orbs::adapters::mitsuba {

/// The integrator of a scene: paths, and around them what makes its layers or Stokes vectors. The channels of
/// both have our names.
std::string integrator_text(const scene::Scene& scene);

/// Why the layers of surfaces cannot be written, "" when they can or there are none.
std::string layer_limit(const scene::Outputs& outputs);

/// The same for Stokes vectors.
std::string stokes_limit(const scene::Scene& scene);

}  // namespace orbs::adapters::mitsuba
