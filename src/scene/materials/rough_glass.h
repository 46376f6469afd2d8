#pragma once

#include "scene/materials/material_type.h"

namespace orbs::scene {

/// Rough dielectric after Walter et al. 2007 with GGX; masking is height-correlated in reflection, separable
/// in transmission.
struct RoughGlass {
  static constexpr const char* kType = "rough_glass";
  RgbColour colour;
  double ior = 1.5;
  double alpha = 0.1;
  bool operator==(const RoughGlass&) const = default;
};

void load(const MaterialEntry& entry, RoughGlass& loaded);
void write(json::Writer& out, const SpectrumList& spectra, const RoughGlass& m);
MaterialRequirement requirement(const RoughGlass& m);
std::vector<EffectVerdict> effects(const SpectrumList& spectra, const RoughGlass& m);
bool is_coloured(const SpectrumList& spectra, const RoughGlass& m);

}  // namespace orbs::scene
