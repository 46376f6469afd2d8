#pragma once

#include "scene/load/spectra.h"
#include "scene/materials/boundary.h"
#include "scene/materials/material_type.h"
#include "scene/materials/reflectance.h"

#include <optional>

namespace orbs::scene {

/// F D G / (4 cos cos) with the D and G of Ggx and F = reflectance + (1 - reflectance) (1 - cos)^5 at the
/// microfacet (Schlick, An Inexpensive BRDF Model for Physically-Based Rendering, 1994, eq. 15).
struct Metal {
  static constexpr const char* kType = "metal";
  RgbColour reflectance;  // at normal incidence
  double alpha = 0.1;
  std::optional<SpectrumUse> spectrum = {};
  bool operator==(const Metal&) const = default;
};

inline void load(const MaterialEntry& entry, Metal& loaded) {
  const auto colour = load_reflectance(entry.in, "reflectance", entry.spectra);
  loaded = {colour.rgb, load_alpha(entry.in), colour.spectrum};
}

inline void write(json::Writer& out, const SpectrumList& spectra, const Metal& m) {
  write_colour(out, spectra, "reflectance", m.reflectance, m.spectrum);
  out.member("alpha", m.alpha);
}

inline MaterialRequirement requirement(const Metal&) { return {"B1", "a metal by its reflectance"}; }

inline std::vector<EffectVerdict> effects(const SpectrumList& spectra, const Metal& m) {
  auto found = effects_of_reflectance(spectra, m.spectrum);
  found.push_back(effect_of(Roughness{m.alpha}));
  return found;
}

inline bool is_coloured(const SpectrumList& spectra, const Metal& m) {
  return is_coloured(spectra, m.reflectance, m.spectrum);
}

}  // namespace orbs::scene
