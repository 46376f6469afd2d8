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

/// Ggx whose alpha is `alpha` times the red channel of a texture, or 1 less that of a texture of glossiness.
/// Below kLeastAlpha it is the mirror.
struct VaryingGgx {
  static constexpr const char* kType = "varying_ggx";
  RgbColour colour;
  std::optional<TextureUse> texture;  // there always is one
  bool is_glossiness = false;
  double alpha = 1;
  Masking masking = Masking::Correlated;
  std::optional<SpectrumUse> spectrum = {};
  bool operator==(const VaryingGgx&) const = default;
};

inline void load(const MaterialEntry& entry, VaryingGgx& loaded) {
  auto& in = entry.in;
  const auto colour = load_reflectance(in, "colour", entry.spectra);
  loaded.colour = colour.rgb;
  loaded.spectrum = colour.spectrum;
  loaded.texture = load_texture_use(entry);
  if (!loaded.texture) in.fail("texture", "is needed: it holds the roughness");
  loaded.is_glossiness = in.one_of("holds", {"alpha", "glossiness"}) == "glossiness";
  if (loaded.is_glossiness && in.has("alpha")) in.fail("alpha", "goes with a texture that holds alpha");
  loaded.alpha = in.number_or("alpha", 1, {1e-4, 1.0});
  loaded.masking = load_masking(in);
}

inline void write(json::Writer& out, const SpectrumList& spectra, const VaryingGgx& m) {
  write_colour(out, spectra, "colour", m.colour, m.spectrum);
  out.member("holds", m.is_glossiness ? "glossiness" : "alpha");
  if (!m.is_glossiness) out.member("alpha", m.alpha);
  out.member("masking", word_of(m.masking));
}

inline MaterialRequirement requirement(const VaryingGgx&) {
  return {"B3", "a glossy reflector whose roughness is a texture"};
}

inline std::vector<EffectVerdict> effects(const SpectrumList& spectra, const VaryingGgx& m) {
  auto found = effects_of_reflectance(spectra, m.spectrum);
  found.push_back({Effect::RoughBoundary, true, "is rough by a texture (GGX)"});
  return found;
}

inline bool is_coloured(const SpectrumList& spectra, const VaryingGgx& m) {
  return is_coloured(spectra, m.colour, m.spectrum);
}

}  // namespace orbs::scene
