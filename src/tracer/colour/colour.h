#pragma once

#include "base/vec.h"

namespace orbs::tracer {

/// A share of the light as the scene gives it: linear Rec.709 and, where the scene says so wavelength by
/// wavelength, the spectrum behind it (of World::spectra; -1: none). RGB paths look at `rgb` alone, spectral
/// ones at the spectrum where there is one.
struct Colour {
  Vec3f rgb;
  int spectrum = -1;
};

/// Light likewise. `share` of the spectrum is meant (what an IES profile leaves in this direction); `rgb` has
/// it already.
struct Radiance {
  Vec3f rgb;
  int spectrum = -1;
  float share = 1;
};

inline bool is_dark(const Radiance& radiance) { return radiance.rgb == Vec3f{} && radiance.spectrum < 0; }

}  // namespace orbs::tracer
