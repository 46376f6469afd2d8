#pragma once

#include "json/writer.h"
#include "scene/load/spectra.h"
#include "scene/materials/boundary.h"
#include "scene/materials/material_type.h"
#include "scene/materials/reflectance.h"
#include "scene/texture.h"

#include <optional>

namespace orbs::scene {

/// The material of glTF 2.0 (appendix B of its specification): a metal and a dielectric of index 1.5 over a
/// diffuse base, mixed by `metallic`.
struct MetallicRoughness {
  static constexpr const char* kType = "metallic_roughness";
  RgbColour reflectance;              // "base_colour" in the file
  std::optional<TextureUse> texture;  // multiplies reflectance
  double metallic = 0;
  double roughness = 1;  // the square root of the alpha of Ggx
  std::optional<SpectrumUse> spectrum = {};
  bool operator==(const MetallicRoughness&) const = default;
};

inline double alpha_of(const MetallicRoughness& m) { return m.roughness * m.roughness; }

inline void load(const MaterialEntry& entry, MetallicRoughness& loaded) {
  const auto colour = load_reflectance(entry.in, "base_colour", entry.spectra);
  loaded = {colour.rgb, load_tinted_texture(entry, colour), entry.in.number("metallic", {0, 1}),
            // The least alpha is that of Ggx.
            entry.in.number("roughness", {0.01, 1}), colour.spectrum};
}

inline void write(json::Writer& out, const SpectrumList& spectra, const MetallicRoughness& m) {
  write_colour(out, spectra, "base_colour", m.reflectance, m.spectrum);
  out.member("metallic", m.metallic).member("roughness", m.roughness);
}

inline MaterialRequirement requirement(const MetallicRoughness&) {
  return {"B7", "a material of metallic and roughness"};
}

inline std::vector<EffectVerdict> effects(const SpectrumList& spectra, const MetallicRoughness& m) {
  auto found = effects_of_reflectance(spectra, m.spectrum);
  found.push_back(effect_of(Roughness{alpha_of(m)}));
  return found;
}

inline bool is_coloured(const SpectrumList& spectra, const MetallicRoughness& m) {
  return m.texture || is_coloured(spectra, m.reflectance, m.spectrum);
}

}  // namespace orbs::scene
