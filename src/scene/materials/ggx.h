#pragma once

#include "scene/load/spectra.h"
#include "scene/materials/boundary.h"
#include "scene/materials/material_type.h"
#include "scene/materials/reflectance.h"

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

inline void load(const MaterialEntry& entry, Ggx& loaded) {
  const auto colour = load_reflectance(entry.in, "colour", entry.spectra);
  loaded = {colour.rgb, load_alpha(entry.in), colour.spectrum};
}

inline void write(json::Writer& out, const SpectrumList& spectra, const Ggx& m) {
  write_colour(out, spectra, "colour", m.colour, m.spectrum);
  out.member("alpha", m.alpha);
}

// No M level of ORB.S defines glossy reflection: it brings that with the paths of A2, as rough glass with A4.
inline MaterialRequirement requirement(const Ggx&) { return {"A2", "a glossy reflector (GGX)"}; }

inline std::vector<EffectVerdict> effects(const SpectrumList& spectra, const Ggx& m) {
  auto found = effects_of_reflectance(spectra, m.spectrum);
  found.push_back(effect_of(Roughness{m.alpha}));
  return found;
}

inline bool is_coloured(const SpectrumList& spectra, const Ggx& m) {
  return is_coloured(spectra, m.colour, m.spectrum);
}

}  // namespace orbs::scene
