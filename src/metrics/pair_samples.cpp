#include "metrics/pair_samples.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

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

// The result's noise in one block and channel: what it says, or else the scatter of horizontal neighbours
// less the reference's share of it.
double noise_of_block(const PairSamples& samples,
                      const Rectangle& block,
                      std::size_t channel,
                      double reference) {
  double sum = 0;
  if (samples.noise_source == NoiseSource::Variances) {
    for_each_block_pixel(samples, block, [&](std::size_t pixel) {
      sum += variance_at(samples.result_variance, 3 * pixel + channel);
    });
    return sum;
  }
  for_each_pair(samples, block, [&](std::size_t a, std::size_t b) {
    const double step = samples.difference(3 * a + channel) - samples.difference(3 * b + channel);
    sum += step * step;
  });
  return std::max(0.0, sum - reference);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void set_variance_ratio(PairSamples& samples) {
  if (samples.reference_variance.empty()) return;
  const auto is_counted = [&](const Rectangle& block) {
    int pixels = 0;
    for_each_block_pixel(samples, block, [&](std::size_t) { ++pixels; });
    return pixels == (block.x1 - block.x0) * (block.y1 - block.y0);
  };
  std::array<std::vector<double>, 3> ratios;
  std::array<double, 3> result_sum{};
  std::array<double, 3> reference_sum{};
  for (const Rectangle& block : blocks_of(samples)) {
    if (!is_counted(block)) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      double reference = 0;
      for_each_block_pixel(samples, block, [&](std::size_t pixel) {
        reference += variance_at(samples.reference_variance, 3 * pixel + c);
      });
      if (!(reference > 0)) continue;
      const double result = noise_of_block(samples, block, c, reference);
      ratios.at(c).push_back(result / reference);
      result_sum.at(c) += result;
      reference_sum.at(c) += reference;
    }
  }
  for (std::size_t c = 0; c < 3; ++c)
    if (!ratios.at(c).empty())
      samples.variance_ratio.at(c) =
          std::max(median(std::move(ratios.at(c))), result_sum.at(c) / reference_sum.at(c));
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
  samples.layers = layer_samples(result, reference);
  if (result_noise == ResultNoise::NoiseFree) {
    samples.noise_source = NoiseSource::Reference;
    return samples;
  }
  samples.result_variance = variances_of(result);
  if (samples.result_variance.empty()) samples.noise_source = NoiseSource::Scatter;
  set_variance_ratio(samples);
  samples.hit_size = hit_size(samples.result_variance, samples.included);
  samples.seen_variance_ratio = samples.variance_ratio;
  return samples;
}

std::array<double, 3> hit_size(const std::vector<float>& variances,
                               const std::vector<std::uint8_t>& included) {
  std::array<double, 3> hits{};
  std::array<double, 3> sums{};
  for (std::size_t i = 0; i < variances.size(); ++i) {
    if (!included.empty() && included[i / 3] == 0) continue;
    const double variance = variance_at(variances, i);
    hits.at(i % 3) += variance * std::sqrt(variance);
    sums.at(i % 3) += variance;
  }
  for (std::size_t c = 0; c < hits.size(); ++c) hits.at(c) = sums.at(c) > 0 ? hits.at(c) / sums.at(c) : 0;
  return hits;
}

void count_samples(PairSamples& samples, double ratio) {
  if (samples.noise_source == NoiseSource::Reference) return;
  for (auto& seen : samples.variance_ratio) seen = std::max(seen, ratio);
}

void reference_steps(const PairSamples& samples, int y, std::vector<double>& steps) {
  const auto row_at = [&](int v) {
    return &samples.reference[3 * samples.pixel_at(0, std::clamp(v, 0, samples.height - 1))];
  };
  const auto step = [](float to, float from) {
    return std::fabs(static_cast<double>(to) - static_cast<double>(from));
  };
  const float* const here = row_at(y);
  const float* const above = row_at(y - 1);
  const float* const below = row_at(y + 1);
  const std::size_t count = 3 * static_cast<std::size_t>(samples.width);
  steps.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double left = i < 3 ? 0.0 : step(here[i - 3], here[i]);
    const double right = i + 3 < count ? step(here[i + 3], here[i]) : 0.0;
    steps[i] = std::max(left, right) + std::max(step(above[i], here[i]), step(below[i], here[i]));
  }
}

bool has_stokes(const image::Image& image) {
  return std::all_of(kStokesLayers.begin(), kStokesLayers.end(), [&](const char* layer) {
    return image::channel_index(image, std::string(layer) + "R") >= 0;
  });
}

std::vector<Rectangle> blocks_of(const PairSamples& samples, int side_px) {
  std::vector<Rectangle> blocks;
  for (int y = 0; y < samples.height; y += side_px)
    for (int x = 0; x < samples.width; x += side_px)
      blocks.push_back({x, y, std::min(x + side_px, samples.width), std::min(y + side_px, samples.height)});
  return blocks;
}

}  // namespace orbs::metrics
