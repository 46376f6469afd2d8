#include "adapters/sampled_spectrum.h"

#include "spectra/observer.h"
#include "spectra/rgb.h"

#include <algorithm>

namespace orbs::adapters {

namespace {

template <typename Value>
Samples sampled(const Value& value_at_nm) {
  Samples samples;
  for (const double nm : sampled_wavelengths_nm()) samples.push_back(static_cast<float>(value_at_nm(nm)));
  const bool is_flat =
      std::all_of(samples.begin(), samples.end(), [&](float value) { return value == samples.front(); });
  if (is_flat) samples.resize(1);
  return samples;
}

}  // namespace

const std::vector<double>& sampled_wavelengths_nm() {
  static const std::vector<double> kWavelengths = [] {
    std::vector<double> out;
    for (double nm = spectra::kShortestSeen_nm; nm <= spectra::kLongestSeen_nm; nm += 1) out.push_back(nm);
    return out;
  }();
  return kWavelengths;
}

Samples samples_of(const spectra::Spectrum& spectrum) {
  return sampled([&](double nm) { return value_at(spectrum, nm); });
}

Samples samples_of_ratio(const spectra::RefractiveIndex& index, const spectra::RefractiveIndex& outside) {
  return sampled([&](double nm) { return index_at(index, nm) / index_at(outside, nm); });
}

Samples samples_of_n(const scene::Conductor& metal) {
  return sampled([&](double nm) { return value_at(metal.index.n, nm) / index_at(metal.outside, nm); });
}

Samples samples_of_k(const scene::Conductor& metal) {
  return sampled([&](double nm) { return value_at(metal.index.k, nm) / index_at(metal.outside, nm); });
}

spectra::Spectrum reflected(const scene::Scene& scene,
                            scene::RgbColour colour,
                            const std::optional<scene::SpectrumUse>& use) {
  return use ? scaled(spectrum_at(scene.spectra, *use).spectrum, use->scale)
             : spectra::reflectance_of_rgb(colour);
}

Samples light_samples(const scene::Scene& scene,
                      scene::RgbColour colour,
                      const std::optional<scene::SpectrumUse>& use) {
  if (use) return samples_of(scaled(spectrum_at(scene.spectra, *use).spectrum, use->scale));
  const spectra::Spectrum tint = spectra::reflectance_of_rgb(colour);
  const spectra::Spectrum& d65 = spectra::illuminant("D65");
  return sampled([&](double nm) { return value_at(tint, nm) * value_at(d65, nm); });
}

double luminance_of(const Samples& light) {
  const auto& wavelengths_nm = sampled_wavelengths_nm();
  double sum = 0;
  for (std::size_t i = 0; i < wavelengths_nm.size(); ++i)
    sum += value_at(spectra::cie_1931().ybar, wavelengths_nm[i]) *
           static_cast<double>(light.size() == 1 ? light[0] : light[i]);
  return sum;
}

}  // namespace orbs::adapters
