#include "adapters/pbrt/colours.h"

#include "adapters/pbrt/bands.h"
#include "scene/effects/effects.h"

#include <iterator>

#include <fmt/format.h>

namespace orbs::adapters::pbrt {

Colours::Colours(const scene::Scene& of)
    : scene(of), is_spectral(scene::transport(of) != scene::LightTransport::Rgb) {}

std::string Colours::surface(const char* name,
                             scene::RgbColour colour,
                             const std::optional<scene::SpectrumUse>& use) const {
  return is_spectral ? spectrum(name, samples_of(reflected(scene, colour, use)))
                     : band_spectrum(name, colour);
}

std::string Colours::radiance(scene::RgbColour colour, const std::optional<scene::SpectrumUse>& use) const {
  if (!is_spectral) return band_radiance(colour);
  const Samples light = light_samples(scene, colour, use);
  const double luminance = luminance_of(light);
  // pbrt divides by the luminance of the spectrum.
  return luminance == 0 ? band_radiance({})
                        : fmt::format("{} \"float scale\" {}", spectrum("L", light), luminance);
}

std::string spectrum(const char* name, const Samples& samples) {
  const auto& wavelengths_nm = sampled_wavelengths_nm();
  std::string pairs;
  if (samples.size() == 1) {
    pairs = fmt::format("{0} {2} {1} {2}", wavelengths_nm.front(), wavelengths_nm.back(), samples.front());
  } else {
    for (std::size_t i = 0; i < samples.size(); ++i)
      fmt::format_to(std::back_inserter(pairs), "{}{} {}", i == 0 ? "" : " ", wavelengths_nm[i], samples[i]);
  }
  return fmt::format("\"spectrum {}\" [{}]", name, pairs);
}

}  // namespace orbs::adapters::pbrt
