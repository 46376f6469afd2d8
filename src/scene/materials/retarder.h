#pragma once

#include "scene/materials/material_type.h"

namespace orbs::scene {

/// Ideal thin element as Polariser. The axis is its fast axis: light polarised across it comes
/// `retardance_deg` late, at all wavelengths.
struct Retarder {
  static constexpr const char* kType = "retarder";
  Vec3d axis;
  double retardance_deg = 90;
  bool operator==(const Retarder&) const = default;
};

void load(const MaterialEntry& entry, Retarder& loaded);
void write(json::Writer& out, const SpectrumList& spectra, const Retarder& m);
MaterialRequirement requirement(const Retarder& m);
std::vector<EffectVerdict> effects(const SpectrumList& spectra, const Retarder& m);
bool is_coloured(const SpectrumList& spectra, const Retarder& m);

}  // namespace orbs::scene
