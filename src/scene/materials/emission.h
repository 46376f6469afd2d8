#pragma once

#include "scene/materials/material_type.h"
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

void load(const MaterialEntry& entry, Emission& loaded);
void write(json::Writer& out, const SpectrumList& spectra, const Emission& m);
MaterialRequirement requirement(const Emission& m);
std::vector<EffectVerdict> effects(const SpectrumList& spectra, const Emission& m);
bool is_coloured(const SpectrumList& spectra, const Emission& m);

}  // namespace orbs::scene
