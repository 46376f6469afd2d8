#include "tracer/colour/scene_colours.h"

namespace orbs::tracer {

int add_spectrum(const SceneColours& colours, const std::optional<scene::SpectrumUse>& use) {
  if (!use || !colours.has_wavelengths) return -1;
  colours.spectra.push_back(
      spectra::scaled(colours.scene.spectra[static_cast<std::size_t>(use->spectrum)].spectrum, use->scale));
  return static_cast<int>(colours.spectra.size()) - 1;
}

Colour make_colour(const SceneColours& colours,
                   const scene::RgbColour& rgb,
                   const std::optional<scene::SpectrumUse>& spectrum) {
  return {cast<float>(rgb), add_spectrum(colours, spectrum)};
}

TexturedColour make_textured_colour(const SceneColours& colours,
                                    const scene::RgbColour& rgb,
                                    const std::optional<scene::SpectrumUse>& spectrum,
                                    const std::optional<scene::TextureUse>& texture) {
  TexturedColour out{make_colour(colours, rgb, spectrum)};
  if (!texture) return out;
  out.texture = texture->texture;
  out.uv = uv_map(texture->matrix);
  return out;
}

}  // namespace orbs::tracer
