#include "adapters/mitsuba/colours.h"

#include "adapters/mitsuba/xml.h"
#include "scene/effects/effects.h"

#include <iterator>

namespace orbs::adapters::mitsuba {

namespace {

std::string list(const char* name, const Samples& samples, double factor) {
  const auto& wavelengths_nm = sampled_wavelengths_nm();
  std::string pairs;
  for (std::size_t i = 0; i < wavelengths_nm.size(); ++i)
    fmt::format_to(std::back_inserter(pairs), "{}{}:{}", i == 0 ? "" : ", ", wavelengths_nm[i],
                   static_cast<float>(factor * static_cast<double>(samples[samples.size() == 1 ? 0 : i])));
  return fmt::format("<spectrum name=\"{}\" value=\"{}\"/>", name, pairs);
}

}  // namespace

Colours::Colours(const scene::Scene& of)
    : scene(of), is_spectral(scene::transport(of) != scene::LightTransport::Rgb) {}

std::string Colours::surface(const char* name,
                             scene::RgbColour colour,
                             const std::optional<scene::SpectrumUse>& use) const {
  return is_spectral ? spectrum(name, samples_of(reflected(scene, colour, use))) : rgb(name, colour);
}

// Mitsuba would take a single number for a multiple of D65.
std::string Colours::emitted(const char* name,
                             scene::RgbColour colour,
                             const std::optional<scene::SpectrumUse>& use) const {
  if (!is_spectral) return rgb(name, colour);
  return list(name, light_samples(scene, colour, use), kEmitterUnit);
}

std::string spectrum(const char* name, const Samples& samples) {
  if (samples.size() > 1) return list(name, samples, 1);
  return fmt::format("<spectrum name=\"{}\" value=\"{}\"/>", name, samples.front());
}

}  // namespace orbs::adapters::mitsuba
