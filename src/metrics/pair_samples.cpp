#include "metrics/pair_samples.h"

#include "base/text.h"

#include <algorithm>
#include <string>

namespace orbs::metrics {

namespace {

std::vector<float> variances_of(const image::Image& image) {
  for (const char* channel : {"variance.R", "variance.G", "variance.B"})
    if (image::channel_index(image, channel) < 0) return {};
  return image::select_rgb(image, "variance.").pixels;
}

constexpr std::array kStokesLayers{"S1.", "S2.", "S3."};

std::optional<StokesSamples> stokes_of(const image::Image& image) {
  if (!has_stokes(image)) return std::nullopt;
  StokesSamples samples;
  for (std::size_t i = 0; i < kStokesLayers.size(); ++i)
    samples.at(i) = image::select_rgb(image, kStokesLayers.at(i)).pixels;
  return samples;
}

// Samples of the reference for each one of the result; 0 when the provenance records do not say.
double sample_ratio(const image::Image& result, const image::Image& reference) {
  const auto said = [](const image::Image& image, const char* key) {
    const auto found = image.attributes.find(key);
    return found == image.attributes.end() ? std::string() : found->second;
  };
  const auto of_result = to_number(said(result, "orbs.spp"));
  const auto of_reference = to_number(said(reference, "orbs.spp"));
  const bool is_same = said(result, "orbs.program") == said(reference, "orbs.program");
  return is_same && of_result && of_reference && *of_result > 0 ? *of_reference / *of_result : 0;
}

void set_variance_ratio(PairSamples& samples, double of_provenances) {
  if (samples.result_variance.empty() || samples.reference_variance.empty()) return;
  for (std::size_t c = 0; c < 3; ++c) {
    double result = 0;
    double reference = 0;
    for (std::size_t pixel = 0; pixel < samples.included.size(); ++pixel) {
      if (samples.included[pixel] == 0) continue;
      result += variance_at(samples.result_variance, 3 * pixel + c);
      reference += variance_at(samples.reference_variance, 3 * pixel + c);
    }
    samples.variance_ratio.at(c) = std::max(of_provenances, reference > 0 ? result / reference : 0.0);
  }
}

}  // namespace

PairSamples pair_samples(const image::Image& result,
                         const image::Image& reference,
                         const Mask& mask,
                         ResultNoise result_noise) {
  PairSamples samples;
  samples.width = result.width;
  samples.height = result.height;
  samples.included = included_pixels(mask, result.width, result.height);
  samples.included_count =
      static_cast<std::size_t>(std::count(samples.included.begin(), samples.included.end(), 1));
  samples.result = image::select_rgb(result, "").pixels;
  samples.reference = image::select_rgb(reference, "").pixels;
  samples.reference_variance = variances_of(reference);
  samples.result_stokes = stokes_of(result);
  samples.reference_stokes = stokes_of(reference);
  if (result_noise == ResultNoise::NoiseFree) {
    samples.noise_source = NoiseSource::Reference;
    return samples;
  }
  samples.result_variance = variances_of(result);
  if (samples.result_variance.empty()) samples.noise_source = NoiseSource::Scatter;
  set_variance_ratio(samples, sample_ratio(result, reference));
  return samples;
}

bool has_stokes(const image::Image& image) {
  return std::all_of(kStokesLayers.begin(), kStokesLayers.end(), [&](const char* layer) {
    return image::channel_index(image, std::string(layer) + "R") >= 0;
  });
}

std::vector<Rectangle> blocks_of(const PairSamples& samples) {
  std::vector<Rectangle> blocks;
  for (int y = 0; y < samples.height; y += kBlock_px)
    for (int x = 0; x < samples.width; x += kBlock_px)
      blocks.push_back(
          {x, y, std::min(x + kBlock_px, samples.width), std::min(y + kBlock_px, samples.height)});
  return blocks;
}

}  // namespace orbs::metrics
