#pragma once

#include "json/object_reader.h"
#include "json/writer.h"
#include "scene/load/spectra.h"
#include "scene/materials/boundary.h"
#include "scene/materials/material_type.h"
#include "scene/materials/reflectance.h"
#include "scene/texture.h"

#include <optional>

namespace orbs::scene {

/// A diffuse base under a clear coat, with all reflections of light inside the coat: the model of Mitsuba's
/// plastic and roughplastic. The coat is smooth without `alpha`; with it, it has the microfacets of a
/// dielectric with GGX and separable masking.
struct Plastic {
  static constexpr const char* kType = "plastic";
  RgbColour reflectance;              // of the base
  std::optional<TextureUse> texture;  // multiplies reflectance
  double ior = 1.5;                   // of the coat over the outside
  bool is_nonlinear = false;          // light that is reflected inside takes the base's colour each time
  std::optional<double> alpha = {};
  std::optional<SpectrumUse> spectrum = {};
  bool operator==(const Plastic&) const = default;
};

inline void load(const MaterialEntry& entry, Plastic& loaded) {
  const auto colour = load_reflectance(entry.in, "reflectance", entry.spectra);
  // A coat thinner than the outside would reflect all light totally at grazing angles.
  loaded = {colour.rgb, load_tinted_texture(entry, colour), entry.in.number("ior", {1, 4}),
            entry.in.boolean_or("nonlinear", false)};
  if (entry.in.has("alpha")) loaded.alpha = load_alpha(entry.in);
  loaded.spectrum = colour.spectrum;
}

inline void write(json::Writer& out, const SpectrumList& spectra, const Plastic& m) {
  write_colour(out, spectra, "reflectance", m.reflectance, m.spectrum);
  out.member("ior", m.ior).member("nonlinear", m.is_nonlinear);
  if (m.alpha) out.member("alpha", *m.alpha);
}

inline MaterialRequirement requirement(const Plastic& m) {
  return m.alpha ? MaterialRequirement{"B5", "rough plastic"} : MaterialRequirement{"B4", "smooth plastic"};
}

inline std::vector<EffectVerdict> effects(const SpectrumList& spectra, const Plastic& m) {
  auto found = effects_of_reflectance(spectra, m.spectrum);
  if (m.alpha) found.push_back(effect_of(Roughness{*m.alpha}));
  return found;
}

inline bool is_coloured(const SpectrumList& spectra, const Plastic& m) {
  return m.texture || is_coloured(spectra, m.reflectance, m.spectrum);
}

}  // namespace orbs::scene
