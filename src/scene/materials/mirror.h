#pragma once

#include "scene/materials/material_type.h"

#include <optional>

namespace orbs::scene {

/// A mirror whose reflectance is the same at all angles, on both sides.
struct Mirror {
  static constexpr const char* kType = "mirror";
  RgbColour reflectance;
  std::optional<SpectrumUse> spectrum = {};
  bool operator==(const Mirror&) const = default;
};

void load(const MaterialEntry& entry, Mirror& loaded);
void write(json::Writer& out, const SpectrumList& spectra, const Mirror& m);
MaterialRequirement requirement(const Mirror& m);
std::vector<EffectVerdict> effects(const SpectrumList& spectra, const Mirror& m);
bool is_coloured(const SpectrumList& spectra, const Mirror& m);

}  // namespace orbs::scene
