#include "references/noise_limits.h"

#include "base/statistics.h"
#include "judge/noise.h"
#include "metrics/pair_samples.h"
#include "metrics/worst_tile.h"
#include "run/looks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include <fmt/format.h>

namespace orbs::references {

namespace {

// Of the pixels of a rectangle, of one channel.
struct Sums {
  double light = 0;
  double variance = 0;
  double pixels = 0;
  double mean() const { return light / pixels; }
  double error() const { return std::sqrt(variance) / pixels; }
};

Sums sums_of(const metrics::PairSamples& samples, const Rectangle& where, std::size_t channel) {
  Sums sums;
  metrics::for_each_block_pixel(samples, where, [&](std::size_t pixel) {
    sums.light += static_cast<double>(samples.reference[3 * pixel + channel]);
    sums.variance += metrics::variance_at(samples.reference_variance, 3 * pixel + channel);
    sums.pixels += 1;
  });
  return sums;
}

double worst_tile_error(const metrics::PairSamples& samples, std::size_t channel, double image_mean) {
  constexpr int kTile = metrics::worst_tile::kSize_px;
  double worst = 0;
  for (int y = 0; y + kTile <= samples.height; y += kTile)
    for (int x = 0; x + kTile <= samples.width; x += kTile) {
      const auto tile = sums_of(samples, {x, y, x + kTile, y + kTile}, channel);
      worst = std::max(worst, tile.error() / (std::max(0.0, tile.mean()) + image_mean));
    }
  return worst;
}

double limit_of(const std::vector<registry::Gate>& gates, const char* metric) {
  const auto* const gate = registry::find_gate(gates, metric);
  return gate == nullptr ? std::numeric_limits<double>::infinity()
                         : gate->max.value_or(std::numeric_limits<double>::infinity());
}

}  // namespace

ReferenceNoise noise_of(const image::Image& image) {
  constexpr double kFirmness = 10;
  ReferenceNoise noise;
  noise.psnr_db = judge::psnr_srgb8_of(judge::noise_mse_srgb8(image, image).value_or(0));
  const auto samples = metrics::pair_samples(image, image);
  for (std::size_t c = 0; c < 3; ++c) {
    const auto all = sums_of(samples, {0, 0, samples.width, samples.height}, c);
    if (!(all.mean() > kFirmness * all.error())) continue;
    noise.mean = std::max(noise.mean, all.error() / all.mean());
    noise.tile = std::max(noise.tile, worst_tile_error(samples, c, all.mean()));
  }
  return noise;
}

ReferenceNoise most_noise(const std::vector<registry::Gate>& gates) {
  constexpr double kHalfOfTheVariance = std::numbers::sqrt2;
  constexpr double kLargestOfTheTiles = 3.6;
  constexpr double kNormal = 1e9;  // degrees of freedom
  // In standard errors, on either side: that of an image that may be looked at so often.
  const double to_pass = student_quantile(2 * metrics::kWrongPasses / run::kMostLooks, kNormal);
  const auto* const psnr = registry::find_gate(gates, "psnr_srgb8");
  auto most = kAnyNoise;
  most.psnr_db = (psnr == nullptr ? 0 : psnr->min.value_or(0)) + kReferenceMargin_db;
  most.mean = limit_of(gates, "mean_ratio_r");
  for (const char* channel : {"mean_ratio_g", "mean_ratio_b"})
    most.mean = std::min(most.mean, limit_of(gates, channel));
  most.mean /= kHalfOfTheVariance * to_pass;
  most.tile = limit_of(gates, "local_bias") / (kHalfOfTheVariance * (to_pass + kLargestOfTheTiles));
  return most;
}

ReferenceNoise stricter(const ReferenceNoise& a, const ReferenceNoise& b) {
  return {std::max(a.psnr_db, b.psnr_db), std::min(a.mean, b.mean), std::min(a.tile, b.tile)};
}

double times_too_noisy(const ReferenceNoise& noise, const ReferenceNoise& most) {
  const auto squared_ratio = [](double error, double limit) { return error * error / (limit * limit); };
  return std::max({std::pow(10, (most.psnr_db - noise.psnr_db) / 10), squared_ratio(noise.mean, most.mean),
                   squared_ratio(noise.tile, most.tile)});
}

std::string noise_text(const ReferenceNoise& noise) {
  auto text = fmt::format("{:.2f} dB", noise.psnr_db);
  if (std::isfinite(noise.mean)) text += fmt::format(", {:.2g} % of the mean", 100 * noise.mean);
  if (std::isfinite(noise.tile)) text += fmt::format(", {:.2g} % of a tile", 100 * noise.tile);
  return text;
}

}  // namespace orbs::references
