#pragma once

#include "scene/load/spectra.h"
#include "scene/materials/material_type.h"
#include "scene/texture.h"

#include <optional>
#include <vector>

/// What materials with a reflectance share: [r, g, b] or a spectrum, and a texture.
namespace orbs::scene {

/// "texture", when there is one. It multiplies `colour`, which must then be no spectrum: neither of the two
/// would say how the light of a texel is spread over the wavelengths.
std::optional<TextureUse> load_tinted_texture(const MaterialEntry& entry, const Colour& colour);

/// Whether the spectrum of a reflectance calls for Effect::Spectral; empty where there is none.
std::vector<EffectVerdict> effects_of_reflectance(const SpectrumList& spectra,
                                                  const std::optional<SpectrumUse>& use);

/// Whether a reflectance differs from wavelength to wavelength.
bool is_coloured(const SpectrumList& spectra, RgbColour rgb, const std::optional<SpectrumUse>& use);

}  // namespace orbs::scene
