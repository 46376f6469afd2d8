#include "adapters/pbrt/colours.h"

#include "adapters/sampled_spectrum.h"
#include "scene/effects/effects.h"

#include <iterator>

#include <fmt/format.h>

namespace orbs::adapters::pbrt {

namespace {

// pbrt rounds a wavelength to the nearest whole nanometre before it looks a spectrum up, so the edges lie
// between two of them.
constexpr double kFirstEdge_nm = 399.5;
constexpr double kBand_nm = 100;
constexpr double kBlueEnd_nm = kFirstEdge_nm + kBand_nm;
constexpr double kGreenEnd_nm = kBlueEnd_nm + kBand_nm;
constexpr double kStep_nm = 1e-4;  // width of the ramp between two steps, which no whole nanometre meets

double step_at(scene::RgbColour colour, double nm) {
  if (nm < kBlueEnd_nm) return colour.z;
  return nm < kGreenEnd_nm ? colour.y : colour.x;
}

double luminance(scene::RgbColour colour) {
  Samples samples;
  for (const double nm : sampled_wavelengths_nm()) samples.push_back(static_cast<float>(step_at(colour, nm)));
  return luminance_of(samples);
}

std::string scaled_image(const std::string& name, scene::RgbColour band, const std::string& image) {
  return fmt::format("Texture \"{}\" \"spectrum\" \"scale\" {} \"texture scale\" \"{}\"\n", name,
                     band_spectrum("tex", band), image);
}

// pbrt has no sum of textures: its mixture of two halves is half of their sum.
std::string mixed(const std::string& name, const std::string& a, const std::string& b) {
  return fmt::format("Texture \"{}\" \"spectrum\" \"mix\" \"texture tex1\" \"{}\" \"texture tex2\" \"{}\"\n",
                     name, a, b);
}

}  // namespace

std::string band_film(const std::string& size) {
  return fmt::format(
      "Film \"spectral\" {} \"integer nbuckets\" 3 \"float lambdamin\" {} \"float lambdamax\" {}", size,
      kFirstEdge_nm, kGreenEnd_nm + kBand_nm);
}

std::array<std::string, 3> band_channels() {
  const auto channel = [](double band) {
    const auto centre_nm = fmt::format("{:.3f}", kFirstEdge_nm + (band + 0.5) * kBand_nm);
    return fmt::format("S0.{},{}nm", centre_nm.substr(0, 3), centre_nm.substr(4));
  };
  return {channel(2), channel(1), channel(0)};
}

std::string band_spectrum(const char* name, scene::RgbColour colour) {
  const auto& seen_nm = sampled_wavelengths_nm();
  return fmt::format("\"spectrum {}\" [{} {} {} {} {} {} {} {} {} {} {} {}]", name, seen_nm.front(), colour.z,
                     kBlueEnd_nm - kStep_nm, colour.z, kBlueEnd_nm, colour.y, kGreenEnd_nm - kStep_nm,
                     colour.y, kGreenEnd_nm, colour.x, seen_nm.back(), colour.x);
}

// pbrt divides by the luminance of the spectrum, which black has not, and its spectral film multiplies by
// that of a flat one.
std::string band_emission(const char* name, scene::RgbColour emission) {
  if (emission == scene::RgbColour{})
    return fmt::format("{} \"float scale\" 0", band_spectrum(name, {1, 1, 1}));
  return fmt::format("{} \"float scale\" {}", band_spectrum(name, emission), luminance(emission));
}

std::string band_texture(const std::string& name, const std::array<std::string, 3>& images) {
  return scaled_image(name + "-r", {4, 0, 0}, images[0]) + scaled_image(name + "-g", {0, 4, 0}, images[1]) +
         scaled_image(name + "-b", {0, 0, 2}, images[2]) + mixed(name + "-rg", name + "-r", name + "-g") +
         mixed(name, name + "-rg", name + "-b");
}

Colours::Colours(const scene::Scene& of)
    : scene(of), is_spectral(scene::transport(of) != scene::LightTransport::Rgb) {}

std::string Colours::surface(const char* name,
                             scene::RgbColour colour,
                             const std::optional<scene::SpectrumUse>& use) const {
  return is_spectral ? spectrum(name, samples_of(reflected(scene, colour, use)))
                     : band_spectrum(name, colour);
}

std::string Colours::emitted(const char* name,
                             scene::RgbColour colour,
                             const std::optional<scene::SpectrumUse>& use) const {
  if (!is_spectral) return band_emission(name, colour);
  const Samples light = light_samples(scene, colour, use);
  const double luminance = luminance_of(light);
  // pbrt divides by the luminance of the spectrum.
  return luminance == 0 ? band_emission(name, {})
                        : fmt::format("{} \"float scale\" {}", spectrum(name, light), luminance);
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
