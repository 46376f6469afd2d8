#include "metrics/local_bias.h"

#include "metrics/describe.h"
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
    }
  return sums;
}

// What the tile's mean is off by for sure; not above 0 when noise may be all there is.
double sure_difference(const Sums& tile) {
  constexpr double kStandardErrors = 5;
  const double mean = tile.difference / tile.count;
  const double variance = std::max(0.0, tile.squares / tile.count - mean * mean);  // rounding only
  return std::fabs(mean) - kStandardErrors * std::sqrt(variance / tile.count);
}

void find_worst_tile(const PairSamples& samples, std::size_t channel, std::optional<LocalBias>& worst) {
  constexpr int kSize = worst_tile::kSize_px;
  const Rectangle all{0, 0, samples.width, samples.height};
  const Sums image = sums_of(samples, all, channel);
  const double image_mean = image.reference / image.count;
  if (!(image_mean > 0)) return;
  for (int y = 0; y < all.y1; y += kSize)
    for (int x = 0; x < all.x1; x += kSize) {
      const Rectangle where{x, y, std::min(x + kSize, all.x1), std::min(y + kSize, all.y1)};
      const Sums tile = sums_of(samples, where, channel);
      if (tile.count < static_cast<double>(worst_tile::kFewestPixels)) continue;
      // Below 0 only in a difference of images, where the image's own mean has to do.
      const double scale = std::max(0.0, tile.reference / tile.count) + image_mean;
      const double value = std::max(0.0, sure_difference(tile)) / scale;
      if (!worst || value > worst->value) worst = {value, where};
    }
}

}  // namespace

std::optional<LocalBias> local_bias(const PairSamples& samples) {
  std::optional<LocalBias> worst;
  for (std::size_t channel = 0; channel < 3; ++channel) find_worst_tile(samples, channel, worst);
  return worst;
}

MetricResult compute_local_bias(const ImagePair& pair) {
  const auto worst = local_bias(pair);
  if (!worst) return {.value = std::nullopt, .absence = Absence::NothingInReference};
  return {.value = worst->value, .where = worst->where};
}

std::string describe_local_bias(const Measurement& measurement, const Limits& limits) {
  if (!measurement.value) return "the reference has no tile with light to be compared with";
  constexpr double kPercent = 100;
  return fmt::format("the mean of the tile {} is off by {:.3g} % or more for sure, {}",
                     rectangle_text(measurement.where.value_or(Rectangle{})), kPercent * *measurement.value,
                     limits_text(limits, kPercent, " %"));
}

}  // namespace orbs::metrics
