#pragma once

#include "scene/load/spectra.h"
#include "scene/materials/material_type.h"
#include "scene/materials/reflectance.h"

#include <optional>

namespace orbs::scene {

/// reflectance (n + 2) / (2 pi) cos^n of the angle between the direction to the light and the mirrored
/// direction to the viewer (Lafortune and Willems, Using the Modified Phong Reflectance Model for Physically
/// Based Rendering, 1994).
struct Phong {
  static constexpr const char* kType = "phong";
  RgbColour reflectance;
  double exponent = 10;  // n
  std::optional<SpectrumUse> spectrum = {};
  bool operator==(const Phong&) const = default;
};

inline void load(const MaterialEntry& entry, Phong& loaded) {
  const auto colour = load_reflectance(entry.in, "reflectance", entry.spectra);
  // A cosine in single precision is off by 6e-8, and its 1000th power by 6e-5 of itself: more would be seen.
  loaded = {colour.rgb, entry.in.number("exponent", {0, 1000}), colour.spectrum};
}

inline void write(json::Writer& out, const SpectrumList& spectra, const Phong& m) {
  write_colour(out, spectra, "reflectance", m.reflectance, m.spectrum);
  out.member("exponent", m.exponent);
}

inline MaterialRequirement requirement(const Phong&) { return {"B8", "a Phong reflector"}; }

inline std::vector<EffectVerdict> effects(const SpectrumList& spectra, const Phong& m) {
  return effects_of_reflectance(spectra, m.spectrum);
}

inline bool is_coloured(const SpectrumList& spectra, const Phong& m) {
  return is_coloured(spectra, m.reflectance, m.spectrum);
}

}  // namespace orbs::scene
