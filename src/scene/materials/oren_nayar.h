#pragma once

#include "json/writer.h"
#include "scene/load/spectra.h"
#include "scene/materials/material_type.h"
#include "scene/materials/reflectance.h"
#include "scene/texture.h"

#include <optional>

namespace orbs::scene {

/// ORB.S eq. 5 with sigma = roughness * pi / 2 radians.
struct OrenNayar {
  static constexpr const char* kType = "oren_nayar";
  RgbColour reflectance;
  double roughness = 0;               // [0, 1]
  std::optional<TextureUse> texture;  // multiplies reflectance
  std::optional<SpectrumUse> spectrum = {};
  bool operator==(const OrenNayar&) const = default;
};

inline void load(const MaterialEntry& entry, OrenNayar& loaded) {
  const auto colour = load_reflectance(entry.in, "reflectance", entry.spectra);
  const double roughness = entry.in.number("roughness", {0.0, 1.0});
  loaded = {colour.rgb, roughness, load_tinted_texture(entry, colour), colour.spectrum};
}

inline void write(json::Writer& out, const SpectrumList& spectra, const OrenNayar& m) {
  write_colour(out, spectra, "reflectance", m.reflectance, m.spectrum);
  out.member("roughness", m.roughness);
}

inline MaterialRequirement requirement(const OrenNayar&) { return {"M7", "Oren-Nayar"}; }

inline std::vector<EffectVerdict> effects(const SpectrumList& spectra, const OrenNayar& m) {
  return effects_of_reflectance(spectra, m.spectrum);
}

inline bool is_coloured(const SpectrumList& spectra, const OrenNayar& m) {
  return m.texture || is_coloured(spectra, m.reflectance, m.spectrum);
}

}  // namespace orbs::scene
