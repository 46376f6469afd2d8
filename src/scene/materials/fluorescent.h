#pragma once

#include "scene/materials/material_type.h"
#include "scene/spectral.h"

#include <optional>

namespace orbs::scene {

/// Lambert's law at every wavelength, on both sides, and re-radiation at longer wavelengths beside it.
struct Fluorescent {
  static constexpr const char* kType = "fluorescent";
  RgbColour reflectance;
  std::optional<SpectrumUse> spectrum;
  Reradiation reradiation;
  bool gains_energy = false;  // more light leaves than arrives, on purpose
  bool operator==(const Fluorescent&) const = default;
};

void load(const MaterialEntry& entry, Fluorescent& loaded);
void write(json::Writer& out, const SpectrumList& spectra, const Fluorescent& m);
MaterialRequirement requirement(const Fluorescent& m);
std::vector<EffectVerdict> effects(const SpectrumList& spectra, const Fluorescent& m);
bool is_coloured(const SpectrumList& spectra, const Fluorescent& m);

}  // namespace orbs::scene
