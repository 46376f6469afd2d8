#pragma once

#include "scene/materials/material_type.h"
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

void load(const MaterialEntry& entry, OrenNayar& loaded);
void write(json::Writer& out, const SpectrumList& spectra, const OrenNayar& m);
MaterialRequirement requirement(const OrenNayar& m);
std::vector<EffectVerdict> effects(const SpectrumList& spectra, const OrenNayar& m);
bool is_coloured(const SpectrumList& spectra, const OrenNayar& m);

}  // namespace orbs::scene
