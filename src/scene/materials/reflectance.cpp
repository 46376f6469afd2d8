#include "scene/materials/reflectance.h"

#include <fmt/format.h>

namespace orbs::scene {

std::optional<TextureUse> load_tinted_texture(const MaterialEntry& entry, const Colour& colour) {
  auto& in = entry.in;
  if (!in.has("texture")) return std::nullopt;
  if (colour.spectrum) in.fail("texture", "goes with a colour [r, g, b], not with a spectrum");
  if (in.holds_text("texture")) return TextureUse{entry.textures.find(in, "texture"), Mat4{}};
  auto use = in.object("texture");
  TextureUse result{entry.textures.find(use, "name"), load_matrix(use, "matrix")};
  use.finish();
  return result;
}

std::vector<EffectVerdict> effects_of_reflectance(const SpectrumList& spectra,
                                                  const std::optional<SpectrumUse>& use) {
  if (!use) return {};
  const auto& [name, spectrum] = spectrum_at(spectra, *use);
  if (use->scale == 0) return {{Effect::Spectral, false, fmt::format("has spectrum '{}' times zero", name)}};
  if (is_constant(spectrum))
    return {{Effect::Spectral, false,
             fmt::format("has spectrum '{}', which is constant, not spectral: a grey says the same", name)}};
  return {{Effect::Spectral, true, fmt::format("reflects by spectrum '{}'", name)}};
}

bool is_coloured(const SpectrumList& spectra, RgbColour rgb, const std::optional<SpectrumUse>& use) {
  return use ? use->scale > 0 && !is_constant(spectrum_at(spectra, *use).spectrum) : !is_grey(rgb);
}

}  // namespace orbs::scene
