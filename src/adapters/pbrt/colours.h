#pragma once

#include "adapters/sampled_spectrum.h"
#include "scene/scene.h"

#include <string>

/// Colours and spectra as pbrt reads them. Where a scene has nothing but colours, each is a spectrum of three
/// steps (bands.h). Where wavelengths count, pbrt gets the spectrum that the colour of the scene stands for,
/// nanometre by nanometre.
namespace orbs::adapters::pbrt {

struct Colours {
  const scene::Scene& scene;
  bool is_spectral = false;  // the scene calls for wavelengths

  explicit Colours(const scene::Scene& of);

  /// The parameter `name` of a surface that reflects this share.
  std::string surface(const char* name,
                      scene::RgbColour colour,
                      const std::optional<scene::SpectrumUse>& use) const;
  /// The radiance of a light. pbrt scales every spectrum to luminance 1, so the luminance is given beside it.
  std::string radiance(scene::RgbColour colour, const std::optional<scene::SpectrumUse>& use) const;
};

/// `"spectrum name" [...]`.
std::string spectrum(const char* name, const Samples& samples);

}  // namespace orbs::adapters::pbrt
