#pragma once

#include "adapters/sampled_spectrum.h"
#include "scene/colour.h"
#include "scene/scene.h"

#include <array>
#include <string>

/// RGB without loss in pbrt, which always computes with wavelengths and would make a smooth spectrum of each
/// colour (Jakob and Hanika 2019): 0.5 to 2 % off after a few bounces, and negative pixels where noise is
/// left. Instead each colour is a spectrum of three steps, one step for each of R, G and B, and the film
/// averages the radiance over each step. Light of one step never reaches another, as in a renderer of three
/// colours.
/// Colours and spectra as pbrt reads them. Where a scene has nothing but colours, each is a spectrum of three
/// steps (bands.h). Where wavelengths count, pbrt gets the spectrum that the colour of the scene stands for,
/// nanometre by nanometre.

namespace orbs::adapters::pbrt {

/// Film that averages over three bands of 100 nm; `size` holds its resolution.
std::string band_film(const std::string& size);

/// Channels of that film's image that hold R, G and B, as SpectralFilm::GetImage names them.
std::array<std::string, 3> band_channels();

/// `"spectrum name" [...]`: the colour as a spectrum of three steps.
std::string band_spectrum(const char* name, scene::RgbColour colour);

/// What a light of that colour emits: `"spectrum name" [...] "float scale" s`.
std::string band_emission(const char* name, scene::RgbColour emission);

/// The spectrum texture `name`, the sum of three float images times their bands. `images` holds the names of
/// the float textures of R, G and B.
std::string band_texture(const std::string& name, const std::array<std::string, 3>& images);

struct Colours {
  const scene::Scene& scene;
  bool is_spectral = false;  // the scene calls for wavelengths

  explicit Colours(const scene::Scene& of);

  /// The parameter `name` of a surface that reflects this share.
  std::string surface(const char* name,
                      scene::RgbColour colour,
                      const std::optional<scene::SpectrumUse>& use) const;
  /// The radiance of a light. pbrt scales every spectrum to luminance 1, so the luminance is given beside it.
  std::string radiance(scene::RgbColour colour, const std::optional<scene::SpectrumUse>& use) const {
    return emitted("L", colour, use);
  }
  /// The same as the parameter `name`: intensity or irradiance.
  std::string emitted(const char* name,
                      scene::RgbColour colour,
                      const std::optional<scene::SpectrumUse>& use) const;
};

/// `"spectrum name" [...]`.
std::string spectrum(const char* name, const Samples& samples);

}  // namespace orbs::adapters::pbrt
