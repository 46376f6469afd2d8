#pragma once

#include "scene/load/spectra.h"
#include "scene/materials/material_type.h"
#include "scene/materials/reflectance.h"
#include "scene/texture.h"

#include <optional>

namespace orbs::scene {

/// Emits `radiance` (times the texture) from both sides and reflects nothing.
struct Emission {
  static constexpr const char* kType = "emission";
  RgbColour radiance;
  std::optional<TextureUse> texture;  // multiplies radiance
  std::optional<SpectrumUse> spectrum = {};
  bool operator==(const Emission&) const = default;
};

inline void load(const MaterialEntry& entry, Emission& loaded) {
  const auto radiance = load_radiance(entry.in, "radiance", entry.spectra);
  loaded = {radiance.rgb, load_tinted_texture(entry, radiance), radiance.spectrum};
}

inline void write(json::Writer& out, const SpectrumList& spectra, const Emission& m) {
  write_colour(out, spectra, "radiance", m.radiance, m.spectrum);
}

inline MaterialRequirement requirement(const Emission&) { return {"M2", "emissive"}; }

// Whether its spectrum counts depends on the surfaces that it lights: scene::effects judges it as a light.
inline std::vector<EffectVerdict> effects(const SpectrumList&, const Emission&) { return {}; }

inline bool is_coloured(const SpectrumList&, const Emission&) { return false; }

}  // namespace orbs::scene
