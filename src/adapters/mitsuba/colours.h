#pragma once

#include "adapters/sampled_spectrum.h"
#include "scene/scene.h"

#include <string>

/// Colours and spectra as Mitsuba reads them. Its variants of three colours get `<rgb>`. In the spectral ones
/// Mitsuba would make spectra of colours by its own model (Jakob and Hanika 2019), so they get the
/// spectrum that the scene means by the colour, nanometre by nanometre.
namespace orbs::adapters::mitsuba {

struct Colours {
  const scene::Scene& scene;
  bool is_spectral = false;  // the scene is for scalar_spectral or scalar_spectral_polarized

  explicit Colours(const scene::Scene& of);

  /// The element `name` of a surface that reflects or transmits this share.
  std::string surface(const char* name,
                      scene::RgbColour colour,
                      const std::optional<scene::SpectrumUse>& use = {}) const;
  /// The radiance of an emitter.
  std::string radiance(scene::RgbColour colour, const std::optional<scene::SpectrumUse>& use) const {
    return emitted("radiance", colour, use);
  }
  /// The element `name` of what an emitter emits.
  std::string emitted(const char* name,
                      scene::RgbColour colour,
                      const std::optional<scene::SpectrumUse>& use) const;
};

/// `<spectrum>` of these values, where Mitsuba takes them as they are (not in an emitter).
std::string spectrum(const char* name, const Samples& samples);

/// Mitsuba multiplies the spectra of emitters that are given as lists by 1 / 106.7502593994140625 and then
/// integrates with the CIE's ybar as printed, which sums to 106.856917; lists of light_samples times this
/// become what they are.
constexpr double kEmitterUnit = 106.7502593994140625 / 106.856917;

}  // namespace orbs::adapters::mitsuba
