#pragma once

#include "base/vec.h"
#include "tracer/colour/texture.h"

namespace orbs::tracer {

/// A reflectance or tint of the scene in linear Rec.709 and, where the scene gives it wavelength by
/// wavelength, as a spectrum (index into World::spectra; -1: none). RGB paths read `rgb` alone, spectral
/// paths read the spectrum where there is one.
struct Colour {
  Vec3f rgb;
  int spectrum = -1;
};

/// A colour that a texture multiplies (index into World::textures; -1: none).
struct TexturedColour {
  Colour colour;
  int texture = -1;
  UvMap uv{};
};

/// Emitted radiance in the same two forms. Only `share` of the spectrum is emitted (the value of the IES
/// profile in this direction); `rgb` contains that factor already.
struct Radiance {
  Vec3f rgb;
  int spectrum = -1;
  float share = 1;
};

inline bool is_dark(const Radiance& radiance) { return radiance.rgb == Vec3f{} && radiance.spectrum < 0; }

}  // namespace orbs::tracer
