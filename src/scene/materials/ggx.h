#pragma once

#include "scene/materials/material_type.h"

#include <optional>

namespace orbs::scene {

/// colour * D G / (4 cos cos), height-correlated Smith-GGX, no Fresnel factor.
struct Ggx {
  static constexpr const char* kType = "ggx";
  RgbColour colour;
  double alpha = 0.1;
  std::optional<SpectrumUse> spectrum = {};
  bool operator==(const Ggx&) const = default;
};

void load(const MaterialEntry& entry, Ggx& loaded);
void write(json::Writer& out, const SpectrumList& spectra, const Ggx& m);
MaterialRequirement requirement(const Ggx& m);
std::vector<EffectVerdict> effects(const SpectrumList& spectra, const Ggx& m);
bool is_coloured(const SpectrumList& spectra, const Ggx& m);

}  // namespace orbs::scene
