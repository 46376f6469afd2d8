#pragma once

#include "base/nth.h"
#include "metrics/metric.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace orbs::metrics {

namespace error_quantiles {

/// The largest |result - reference| of the three channels.
inline float error_of(const ImagePair& pair, std::size_t pixel) {
  float largest = 0.0F;
  for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i)
    largest = std::max(largest, std::fabs(pair.result[i] - pair.reference[i]));
  return largest;
}

/// The smallest error that at least `share` of the unmasked pixels do not exceed.
inline MetricResult quantile(const ImagePair& pair, double share) {
  std::vector<float> errors;
  errors.reserve(pair.included_count);
  for (std::size_t pixel = 0; pixel < pair.pixel_count(); ++pixel)
    if (pair.included[pixel] != 0) errors.push_back(error_of(pair, pixel));
  const auto rank = static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(errors.size()))) - 1;
  std::nth_element(errors.begin(), errors.begin() + rank, errors.end());
  return {static_cast<double>(nth(errors, rank)), {}};
}

}  // namespace error_quantiles

inline MetricResult compute_error_p95(const ImagePair& pair) { return error_quantiles::quantile(pair, 0.95); }

inline MetricResult compute_error_p99(const ImagePair& pair) { return error_quantiles::quantile(pair, 0.99); }

inline MetricResult compute_error_max(const ImagePair& pair) {
  float largest = -1.0F;
  std::size_t at = 0;
  for (std::size_t pixel = 0; pixel < pair.pixel_count(); ++pixel) {
    if (pair.included[pixel] == 0) continue;
    const float error = error_quantiles::error_of(pair, pixel);
    if (error <= largest) continue;
    largest = error;
    at = pixel;
  }
  const auto width = static_cast<std::size_t>(pair.width);
  const auto x = static_cast<int>(at % width);
  const auto y = static_cast<int>(at / width);
  return {static_cast<double>(largest), {}, Rectangle{x, y, x + 1, y + 1}};
}

inline constexpr MetricInfo kErrorP95{
    "error_p95",
    "radiance",
    Better::Lower,
    "the smallest error that 95 % of the unmasked pixels do not exceed; the error of a pixel is the "
    "largest |result - reference| of its channels R, G, B; linear Rec.709, no clamp, no exposure",
    kNoMap,
    compute_error_p95};

inline constexpr MetricInfo kErrorP99{
    "error_p99",
    "radiance",
    Better::Lower,
    "the smallest error that 99 % of the unmasked pixels do not exceed; the error of a pixel is the "
    "largest |result - reference| of its channels R, G, B; linear Rec.709, no clamp, no exposure",
    kNoMap,
    compute_error_p99};

inline constexpr MetricInfo kErrorMax{
    "error_max",
    "radiance",
    Better::Lower,
    "the largest |result - reference| of any channel R, G, B of any unmasked pixel, and the pixel that "
    "has it (the first by rows from the top); linear Rec.709, no clamp, no exposure",
    kNoMap,
    compute_error_max};

}  // namespace orbs::metrics
