#pragma once

#include "metrics/pair_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>

/// What a right layer may hold in a pixel, by the reference and by the precision of floats.
namespace orbs::metrics {

constexpr double kHalfStep = 1.0 / 1024;  // of a half float, relative to its value
/// A few roundings of single precision, relative to the largest value of the layer: a zero among the parts of
/// a unit vector or of a position is seldom one to the last digit.
constexpr double kLayerRounding = 0x1p-20;

/// The largest value of the layer in the reference, where a surface is; 1 for a coverage, and of zeros.
inline double layer_size(const PairSamples& samples, const ComparedLayer& of) {
  if (of.layer->kind != image::LayerKind::Mean) return 1;
  double size = 0;
  for (const auto& channel : of.channels)
    for (std::size_t i = 0; i < channel.reference.size(); ++i)
      if (samples.layers->coverage[i] > 0)
        size = std::max(size, static_cast<double>(std::fabs(channel.reference[i])));
  return size > 0 ? size : 1;
}

/// Calls visit(neighbour) for the pixel and those beside it.
template <typename Visit>
void for_each_neighbour(const PairSamples& samples, std::size_t pixel, Visit visit) {
  const int x = static_cast<int>(pixel) % samples.width;
  const int y = static_cast<int>(pixel) / samples.width;
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, samples.height - 1); ++v)
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, samples.width - 1); ++u)
      visit(samples.pixel_at(u, v));
}

struct LayerRange {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
};

/// Of all that the reference shows in the pixel and its neighbours, where a surface is.
inline LayerRange range_beside(const PairSamples& samples, const LayerChannel& channel, std::size_t pixel) {
  LayerRange range;
  for_each_neighbour(samples, pixel, [&](std::size_t i) {
    if (!(samples.layers->coverage[i] > 0)) return;
    range.least = std::min(range.least, static_cast<double>(channel.least[i]));
    range.most = std::max(range.most, static_cast<double>(channel.most[i]));
  });
  return range;
}

}  // namespace orbs::metrics
