#pragma once

#include "scene/load/spectra.h"
#include "scene/materials/material_type.h"
#include "scene/surface_detail.h"
#include "scene/texture.h"

#include <optional>
#include <vector>

#include <fmt/format.h>

/// What materials with a reflectance share: [r, g, b] or a spectrum, and a texture.

namespace orbs::scene {

/// "texture", when there is one.
inline std::optional<TextureUse> load_texture_use(const MaterialEntry& entry) {
  if (!entry.in.has("texture")) return std::nullopt;
  return load_texture_use(entry.in, "texture", entry.textures);
}

/// The same where it multiplies `colour`, which must then be no spectrum: neither of the two would say how
/// the light of a texel is spread over the wavelengths.
inline std::optional<TextureUse> load_tinted_texture(const MaterialEntry& entry, const Colour& colour) {
  if (colour.spectrum && entry.in.has("texture"))
    entry.in.fail("texture", "goes with a colour [r, g, b], not with a spectrum");
  return load_texture_use(entry);
}

/// Whether the spectrum of a reflectance calls for Effect::Spectral; empty where there is none.
inline std::vector<EffectVerdict> effects_of_reflectance(const SpectrumList& spectra,
                                                         const std::optional<SpectrumUse>& use) {
  if (!use) return {};
  const auto& [name, spectrum] = spectrum_at(spectra, *use);
  if (use->scale == 0) return {{Effect::Spectral, false, fmt::format("has spectrum '{}' times zero", name)}};
  if (is_constant(spectrum))
    return {{Effect::Spectral, false,
             fmt::format("has spectrum '{}', which is constant, not spectral: a grey says the same", name)}};
  return {{Effect::Spectral, true, fmt::format("reflects by spectrum '{}'", name)}};
}

/// Whether a reflectance differs from wavelength to wavelength.
inline bool is_coloured(const SpectrumList& spectra, RgbColour rgb, const std::optional<SpectrumUse>& use) {
  return use ? use->scale > 0 && !is_constant(spectrum_at(spectra, *use).spectrum) : !is_grey(rgb);
}

}  // namespace orbs::scene
