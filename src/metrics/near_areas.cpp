#include "metrics/near_areas.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace orbs::metrics {

namespace {

struct Sums {
  double difference = 0;
  double squares = 0;
  double variance = 0;
};

// Of one block; nothing where no channel has noise there.
std::optional<double> share_of(const PairSamples& samples, const Rectangle& block) {
  double share = 0;
  int channels = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    Sums sums;
    for_each_block_pixel(samples, block, [&](std::size_t pixel) {
      const std::size_t i = 3 * pixel + c;
      const double off = samples.difference(i);
      sums.difference += off;
      sums.squares += off * off;
      sums.variance += variance_at(samples.result_variance, i) + variance_at(samples.reference_variance, i);
    });
    const double expected = std::min(sums.squares, sums.variance);
    if (!(expected > 0)) continue;
    share += sums.difference * sums.difference / expected;
    ++channels;
  }
  if (channels == 0) return std::nullopt;
  return share / channels;
}

// Blocks that the image cuts off are left out.
NearAreas areas_of(const PairSamples& samples, int side) {
  NearAreas areas{.side_px = side};
  double sum = 0;
  for (int y = 0; y + side <= samples.height; y += side)
    for (int x = 0; x + side <= samples.width; x += side)
      if (const auto share = share_of(samples, {x, y, x + side, y + side})) {
        sum += *share;
        ++areas.count;
      }
  areas.share = areas.count > 0 ? sum / areas.count : 1;
  return areas;
}

double probability_at_most(const NearAreas& areas) {
  if (areas.share >= 1) return 1;
  if (!(areas.share > 0)) return 0;
  return std::exp(areas.count / 2.0 * (1 - areas.share + std::log(areas.share)));
}

}  // namespace

std::optional<NearAreas> near_areas(const PairSamples& samples, double false_alarms) {
  constexpr std::array kSides_px{8, 16, 32};
  constexpr int kFewest = 16;
  constexpr double kMost = 1.0 / 3;
  if (samples.noise_source != NoiseSource::Variances) return std::nullopt;
  std::optional<NearAreas> nearest;
  for (const int side : kSides_px) {
    const auto areas = areas_of(samples, side);
    if (areas.count < kFewest || areas.share > kMost || probability_at_most(areas) > false_alarms) continue;
    if (!nearest || areas.share < nearest->share) nearest = areas;
  }
  return nearest;
}

}  // namespace orbs::metrics
