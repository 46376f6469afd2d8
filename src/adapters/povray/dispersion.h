#pragma once

#include "scene/scene.h"

namespace orbs::adapters::povray {

/// POV-Ray 3.7 draws dispersion as rays of several colours, spread evenly from 380 to 730 nm. Each is
/// refracted by ior * dispersion^((555 nm - wavelength) / 350 nm), and its colour is from a fit that puts
/// blue, green and red around 474, 582 and 650 nm (source/backend/colour/spectral.cpp there).
struct Dispersion {
  double ior = 1;
  double dispersion = 1;
};

/// The two numbers with which POV-Ray's blue, green and red are refracted most like the light that makes
/// Rec.709's blue, green and red.
Dispersion dispersion_of(const scene::Dielectric& glass);

}  // namespace orbs::adapters::povray
