#pragma once

#include "adapters/sampled_spectrum.h"
#include "scene/scene.h"

#include <string>

/// Colours and spectra as pbrt reads them. pbrt always computes with wavelengths and makes spectra of colours
/// by a model of its own (Jakob and Hanika 2019), which is accurate enough where a scene has nothing but
/// colours. Where wavelengths count it gets the spectrum that the colour of the scene stands for, nanometre
/// by nanometre.
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
