#pragma once

#include "base/nth.h"
#include "base/vec.h"
#include "spectra/spectrum.h"

#include <string>
#include <vector>

/// Colours of a scene, and the spectra that may stand in their place. Where a scene gives a colour alone,
/// linear Rec.709 means spectra::reflectance_of_rgb for surfaces, and that times D65 for lights.
namespace orbs::scene {

/// Linear Rec.709.
using RgbColour = Vec3d;
inline bool is_grey(RgbColour c) { return c.x == c.y && c.y == c.z; }

struct NamedSpectrum {
  std::string name;
  spectra::Spectrum spectrum;
  bool operator==(const NamedSpectrum&) const = default;
};
using SpectrumList = std::vector<NamedSpectrum>;

/// A spectrum of the scene instead of a colour: its values times `scale`. The colour beside it is then
/// the sensor's response to it: to a surface under D65, to a light by itself. It may lie outside of Rec.709,
/// hence be negative.
struct SpectrumUse {
  int spectrum = 0;  // index into Scene::spectra
  double scale = 1;
  bool operator==(const SpectrumUse&) const = default;
};

inline const NamedSpectrum& spectrum_at(const SpectrumList& spectra, const SpectrumUse& use) {
  return nth(spectra, use.spectrum);
}

}  // namespace orbs::scene
