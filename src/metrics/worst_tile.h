#pragma once

#include "metrics/metric.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace orbs::metrics {

namespace worst_tile {

constexpr int kSize_px = 16;
constexpr std::size_t kFewestPixels = 64;  // a quarter of a tile: fewer would make it a second error_max

/// Mean |result - reference| over R, G, B of the tile's unmasked pixels; nothing when they are too few.
inline std::optional<double> error_of(const ImagePair& pair, const Rectangle& tile) {
  double sum = 0.0;
  std::size_t count = 0;
  for (int y = tile.y0; y < tile.y1; ++y)
    for (int x = tile.x0; x < tile.x1; ++x) {
      const auto pixel =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(pair.width) + static_cast<std::size_t>(x);
      if (pair.included[pixel] == 0) continue;
      for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i)
        sum += std::fabs(static_cast<double>(pair.result[i]) - static_cast<double>(pair.reference[i]));
      ++count;
    }
  if (count < kFewestPixels) return std::nullopt;
  return sum / (3.0 * static_cast<double>(count));
}

}  // namespace worst_tile

inline MetricResult compute_worst_tile(const ImagePair& pair) {
  constexpr int kSize = worst_tile::kSize_px;
  MetricResult worst;
  for (int y = 0; y < pair.height; y += kSize)
    for (int x = 0; x < pair.width; x += kSize) {
      const Rectangle tile{x, y, std::min(x + kSize, pair.width), std::min(y + kSize, pair.height)};
      const auto error = worst_tile::error_of(pair, tile);
      if (!error || (worst.value && *error <= *worst.value)) continue;
      worst.value = error;
      worst.where = tile;
    }
  return worst;
}

inline constexpr MetricInfo kWorstTile{
    "l1_worst_tile",
    "radiance",
    Better::Lower,
    "the largest l1 of any tile of 16 x 16 pixels, and the tile that has it (the first by rows); tiles "
    "are counted from the upper left corner, those at the right and lower edge may be smaller, and tiles "
    "with less than 64 unmasked pixels are left out; linear Rec.709, no clamp, no exposure",
    kNoMap,
    compute_worst_tile};

}  // namespace orbs::metrics
