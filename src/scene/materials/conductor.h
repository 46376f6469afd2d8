#pragma once

#include "scene/materials/material_type.h"
#include "scene/spectral.h"

#include <optional>

namespace orbs::scene {

/// A conductor by its indices: reflectance, phase and polarisation follow from Fresnel's formulas, or with a
/// film from Airy's sum; smooth without `roughness`. It is black from behind.
struct Conductor {
  static constexpr const char* kType = "conductor";
  spectra::MetalIndex index;
  spectra::RefractiveIndex outside = spectra::constant(1);
  std::optional<Roughness> roughness;
  std::optional<Film> film;
  bool operator==(const Conductor&) const = default;
};

void load(const MaterialEntry& entry, Conductor& loaded);
void write(json::Writer& out, const SpectrumList& spectra, const Conductor& m);
MaterialRequirement requirement(const Conductor& m);
std::vector<EffectVerdict> effects(const SpectrumList& spectra, const Conductor& m);
bool is_coloured(const SpectrumList& spectra, const Conductor& m);

/// Makes the metal as it would be without the effect: MeasuredMetal and ThinFilm; others change nothing.
void leave_out(Effect effect, Conductor& m);

}  // namespace orbs::scene
