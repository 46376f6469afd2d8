#pragma once

#include "scene/materials/material_type.h"
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

void load(const MaterialEntry& entry, Lambert& loaded);
void write(json::Writer& out, const SpectrumList& spectra, const Lambert& m);
MaterialRequirement requirement(const Lambert& m);
std::vector<EffectVerdict> effects(const SpectrumList& spectra, const Lambert& m);
bool is_coloured(const SpectrumList& spectra, const Lambert& m);

}  // namespace orbs::scene
