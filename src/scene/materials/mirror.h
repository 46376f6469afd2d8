#pragma once

#include "json/writer.h"
#include "scene/load/spectra.h"
#include "scene/materials/material_type.h"
#include "scene/materials/reflectance.h"

#include <optional>

namespace orbs::scene {

/// A mirror whose reflectance is the same at all angles, on both sides.
struct Mirror {
  static constexpr const char* kType = "mirror";
  RgbColour reflectance;
  std::optional<SpectrumUse> spectrum = {};
  bool operator==(const Mirror&) const = default;
};

inline void load(const MaterialEntry& entry, Mirror& loaded) {
  const auto colour = load_reflectance(entry.in, "reflectance", entry.spectra);
  loaded = {colour.rgb, colour.spectrum};
}

inline void write(json::Writer& out, const SpectrumList& spectra, const Mirror& m) {
  write_colour(out, spectra, "reflectance", m.reflectance, m.spectrum);
}

inline MaterialRequirement requirement(const Mirror&) { return {"M3", "a mirror"}; }

inline std::vector<EffectVerdict> effects(const SpectrumList& spectra, const Mirror& m) {
  return effects_of_reflectance(spectra, m.spectrum);
}

inline bool is_coloured(const SpectrumList& spectra, const Mirror& m) {
  return is_coloured(spectra, m.reflectance, m.spectrum);
}

}  // namespace orbs::scene
