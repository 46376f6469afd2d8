#include "metrics/local_bias.h"

#include "base/statistics.h"
#include "metrics/common_noise.h"
#include "metrics/describe.h"
#include "metrics/rare_light.h"
#include "metrics/worst_tile.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace orbs::metrics {

namespace {

struct Sums {
  double count = 0;
  double difference = 0;
  double squares = 0;  // of the differences
  double reference = 0;
  double expected = 0;  // variance of `difference` by the numbers of samples; 0 where there is one look
};

Sums sums_of(const PairSamples& samples, const Rectangle& tile, std::size_t channel) {
  Sums sums;
  for (int y = tile.y0; y < tile.y1; ++y)
    for (int x = tile.x0; x < tile.x1; ++x) {
      const auto pixel = samples.pixel_at(x, y);
      if (samples.included[pixel] == 0) continue;
      const std::size_t i = 3 * pixel + channel;
      const double reference = static_cast<double>(samples.reference[i]);
      const double difference = static_cast<double>(samples.result[i]) - reference;
      sums.count += 1;
      sums.difference += difference;
      sums.squares += difference * difference;
      sums.reference += reference;
      if (samples.looks > 1)
        sums.expected +=
            (samples.variance_ratio.at(channel) + 1) * variance_at(samples.reference_variance, i);
    }
  return sums;
}

// By the tile's own pixels.
double seen_error(const Sums& tile) {
  const double mean = tile.difference / tile.count;
  const double variance = std::max(0.0, tile.squares / tile.count - mean * mean);  // rounding only
  return std::sqrt(variance / tile.count);
}

// How many standard errors are certain, and how many a pass must keep within the limit.
struct Reaches {
  double certain = 5;
  double outside = 2.9e-7;  // the probability of more than `certain` on one side
  double to_pass = 0;
};

int tiles_along(int length_px) { return (length_px + worst_tile::kSize_px - 1) / worst_tile::kSize_px; }

Reaches reaches_of(const PairSamples& samples) {
  constexpr double kPixelsOfATile = worst_tile::kSize_px * worst_tile::kSize_px;
  if (samples.looks == 1) return {};
  const double tests = 3.0 * tiles_along(samples.width) * tiles_along(samples.height);
  const double outside = kWrongFails / (samples.looks * tests);
  return {student_quantile(2 * outside, kPixelsOfATile - 1), outside,
          student_quantile(2 * kWrongPasses / samples.looks, kPixelsOfATile - 1)};
}

void find_worst_tile(const PairSamples& samples,
                     std::size_t channel,
                     const Reaches& reaches,
                     std::optional<LocalBias>& worst) {
  constexpr int kSize = worst_tile::kSize_px;
  const Rectangle all{0, 0, samples.width, samples.height};
  const Sums image = sums_of(samples, all, channel);
  const double image_mean = image.reference / image.count;
  if (!(image_mean > 0)) return;
  const double share = common_share(samples, channel);
  for (int y = 0; y < all.y1; y += kSize)
    for (int x = 0; x < all.x1; x += kSize) {
      const Rectangle where{x, y, std::min(x + kSize, all.x1), std::min(y + kSize, all.y1)};
      const Sums tile = sums_of(samples, where, channel);
      if (tile.count < static_cast<double>(worst_tile::kFewestPixels)) continue;
      // Below 0 only in a difference of images, where the image's own mean has to do.
      const double scale = std::max(0.0, tile.reference / tile.count) + image_mean;
      const double off = std::fabs(tile.difference / tile.count);
      const double seen = seen_error(tile);
      const double error = std::max(seen, std::sqrt(tile.expected) / tile.count) *
                           std::sqrt(samples.area_noise.over_16px.at(channel));
      const double unseen =
          tile.difference < 0 ? unseen_light(samples, where, channel, reaches.outside) / tile.count : 0;
      const double in_common = share * std::fabs(tile.reference / tile.count);
      const double value = std::max(0.0, off - in_common - std::max(reaches.certain * error, unseen)) / scale;
      const double largest = std::max(worst ? worst->largest : 0, (off + reaches.to_pass * error) / scale);
      if (!worst || value > worst->value) worst = {value, where};
      worst->largest = largest;
    }
}

}  // namespace

std::optional<LocalBias> local_bias(const PairSamples& samples) {
  std::optional<LocalBias> worst;
  const auto reaches = reaches_of(samples);
  for (std::size_t channel = 0; channel < 3; ++channel) find_worst_tile(samples, channel, reaches, worst);
  return worst;
}

MetricResult compute_local_bias(const ImagePair& pair) {
  const auto worst = local_bias(pair);
  if (!worst) return {.value = std::nullopt, .absence = Absence::NothingInReference};
  MetricResult result{.value = worst->value, .where = worst->where};
  if (pair.looks > 1) result.to_pass = ToPass{0, worst->largest};
  return result;
}

std::string describe_local_bias(const Measurement& measurement, const Limits& limits) {
  if (!measurement.value) return "the reference has no tile with light to be compared with";
  constexpr double kPercent = 100;
  return fmt::format("the mean of the tile {} is off by {:.3g} % or more for sure, {}",
                     rectangle_text(measurement.where.value_or(Rectangle{})), kPercent * *measurement.value,
                     limits_text(limits, kPercent, " %"));
}

}  // namespace orbs::metrics
