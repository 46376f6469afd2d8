#pragma once

#include "json/writer.h"
#include "scene/load/spectra.h"
#include "scene/materials/material_type.h"
#include "scene/materials/reflectance.h"
#include "scene/texture.h"

#include <optional>

namespace orbs::scene {

/// Lambert's law, on both sides of the surface.
struct Lambert {
  static constexpr const char* kType = "lambert";
  RgbColour reflectance;
  std::optional<TextureUse> texture;  // multiplies reflectance
  std::optional<SpectrumUse> spectrum = {};
  bool operator==(const Lambert&) const = default;
};

inline void load(const MaterialEntry& entry, Lambert& loaded) {
  const auto colour = load_reflectance(entry.in, "reflectance", entry.spectra);
  loaded = {colour.rgb, load_tinted_texture(entry, colour), colour.spectrum};
}

inline void write(json::Writer& out, const SpectrumList& spectra, const Lambert& m) {
  write_colour(out, spectra, "reflectance", m.reflectance, m.spectrum);
}

inline MaterialRequirement requirement(const Lambert&) { return {"M1", "Lambertian"}; }

inline std::vector<EffectVerdict> effects(const SpectrumList& spectra, const Lambert& m) {
  return effects_of_reflectance(spectra, m.spectrum);
}

inline bool is_coloured(const SpectrumList& spectra, const Lambert& m) {
  return m.texture || is_coloured(spectra, m.reflectance, m.spectrum);
}

}  // namespace orbs::scene
