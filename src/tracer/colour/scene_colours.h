#pragma once

#include "base/nth.h"
#include "scene/scene.h"
#include "tracer/colour/colour.h"

#include <optional>
#include <vector>

namespace orbs::tracer {

/// Turns colours of a scene into those of the tracer and collects the spectra that they refer to.
struct SceneColours {
  const scene::Scene& scene;
  bool has_wavelengths = false;             // paths carry wavelengths; RGB paths need no spectra
  std::vector<spectra::Spectrum>& spectra;  // of the world, scales applied
};

/// Appends the spectrum to `colours.spectra` and returns its index; -1 if there is none or paths carry RGB.
inline int add_spectrum(const SceneColours& colours, const std::optional<scene::SpectrumUse>& use) {
  if (!use || !colours.has_wavelengths) return -1;
  colours.spectra.push_back(spectra::scaled(nth(colours.scene.spectra, use->spectrum).spectrum, use->scale));
  return static_cast<int>(colours.spectra.size()) - 1;
}

inline Colour make_colour(const SceneColours& colours,
                          const scene::RgbColour& rgb,
                          const std::optional<scene::SpectrumUse>& spectrum = std::nullopt) {
  return {cast<float>(rgb), add_spectrum(colours, spectrum)};
}

inline TexturedColour make_textured_colour(const SceneColours& colours,
                                           const scene::RgbColour& rgb,
                                           const std::optional<scene::SpectrumUse>& spectrum,
                                           const std::optional<scene::TextureUse>& texture) {
  TexturedColour out{make_colour(colours, rgb, spectrum)};
  if (!texture) return out;
  out.texture = texture->texture;
  out.uv = uv_map(*texture, scene::texture_at(colours.scene, *texture));
  return out;
}

}  // namespace orbs::tracer
