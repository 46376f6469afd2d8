#pragma once

#include "scene/materials/material_type.h"

namespace orbs::scene {

/// Ideal thin element that light crosses straight on. The axis, a world direction, is projected into the
/// surface: along it a polariser transmits everything, across it nothing.
struct Polariser {
  static constexpr const char* kType = "polariser";
  Vec3d axis;
  bool operator==(const Polariser&) const = default;
};

void load(const MaterialEntry& entry, Polariser& loaded);
void write(json::Writer& out, const SpectrumList& spectra, const Polariser& m);
MaterialRequirement requirement(const Polariser& m);
std::vector<EffectVerdict> effects(const SpectrumList& spectra, const Polariser& m);
bool is_coloured(const SpectrumList& spectra, const Polariser& m);

/// "axis", a direction of any length but zero, as polarisers and retarders have it.
Vec3d load_axis(json::ObjectReader& in);

}  // namespace orbs::scene
