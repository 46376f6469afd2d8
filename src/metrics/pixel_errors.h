#pragma once

#include "metrics/metric.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

/// Means of an error of each pixel and channel.
namespace orbs::metrics {

inline MetricResult compute_l1(const ImagePair& pair) {
  return mean_error(pair, pair.result, pair.reference, [](double t, double r) { return std::fabs(t - r); });
}

inline constexpr MetricInfo kL1{
    "l1",
    "radiance",
    Better::Lower,
    "mean of |result - reference| over the channels R, G, B of all unmasked pixels; linear Rec.709, no "
    "clamp, no exposure",
    {"l1", "|result - reference| in each channel; linear Rec.709, no clamp", false, 0.2F},
    compute_l1};

inline MetricResult compute_mse(const ImagePair& pair) {
  return mean_error(pair, pair.result, pair.reference, [](double t, double r) { return (t - r) * (t - r); });
}

inline constexpr MapInfo kSquaredMap{
    "squared", "(result - reference)^2 in each channel; linear Rec.709, no clamp", false, 0.04F};

inline constexpr MetricInfo kMse{"mse",
                                 "radiance^2",
                                 Better::Lower,
                                 "mean of (result - reference)^2 over the channels R, G, B of all "
                                 "unmasked pixels; linear Rec.709, no clamp, no exposure",
                                 kSquaredMap,
                                 compute_mse};

inline MetricResult compute_smape(const ImagePair& pair) {
  // In each magnitude half of JERI's 0.02: keeps black pixels defined.
  constexpr double kEpsilon = 0.01;
  return mean_error(pair, pair.result, pair.reference, [](double t, double r) {
    return 2.0 * std::fabs(t - r) / (std::fabs(t) + std::fabs(r) + 2.0 * kEpsilon);
  });
}

inline constexpr MetricInfo kSmape{
    "smape",
    "1",
    Better::Lower,
    "mean of 2 |result - reference| / (|result| + |reference| + 0.02) over the channels R, G, B of all "
    "unmasked pixels, from 0 to 2; linear Rec.709, no clamp, no exposure",
    {"smape",
     "2 |result - reference| / (|result| + |reference| + 0.02) in each channel; linear Rec.709, no clamp",
     false, 0.5F},
    compute_smape};

namespace relmse {

/// In radiance^2: what keeps black pixels from outweighing all others. It is absolute, so the number is that
/// of the scene's unit of light. 0.01 is what tev and Rousselle, Knaus, Zwicker 2011 divide by.
constexpr double kEpsilon = 0.01;
constexpr double kTrimmedShare = 0.001;

inline double error(double t, double r) { return (t - r) * (t - r) / (r * r + kEpsilon); }

/// Mean of `values` without the largest floor(share * count), summed in their order.
inline double trimmed_mean(const std::vector<double>& values, double share) {
  const auto dropped = static_cast<std::size_t>(share * static_cast<double>(values.size()));
  const std::size_t kept = values.size() - dropped;
  std::vector<double> ordered = values;
  const auto largest_kept = ordered.begin() + static_cast<std::ptrdiff_t>(kept - 1);
  std::nth_element(ordered.begin(), largest_kept, ordered.end());
  double sum = 0.0;
  std::size_t below = 0;
  for (const double value : values)
    if (value < *largest_kept) {
      sum += value;
      ++below;
    }
  return (sum + *largest_kept * static_cast<double>(kept - below)) / static_cast<double>(kept);
}

}  // namespace relmse

inline MetricResult compute_relmse(const ImagePair& pair) {
  return mean_error(pair, pair.result, pair.reference, relmse::error);
}

inline MetricResult compute_relmse_trimmed(const ImagePair& pair) {
  std::vector<double> of_pixels;
  of_pixels.reserve(pair.included_count);
  for (std::size_t pixel = 0; pixel < pair.pixel_count(); ++pixel) {
    if (pair.included[pixel] == 0) continue;
    double sum = 0.0;
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i)
      sum += relmse::error(static_cast<double>(pair.result[i]), static_cast<double>(pair.reference[i]));
    of_pixels.push_back(sum / 3.0);
  }
  return {relmse::trimmed_mean(of_pixels, relmse::kTrimmedShare), {}};
}

inline constexpr MetricInfo kRelMse{
    "relmse_eps01",
    "1",
    Better::Lower,
    "mean of (result - reference)^2 / (reference^2 + 0.01) over the channels R, G, B of all unmasked "
    "pixels; linear Rec.709, no clamp, no exposure",
    {"relmse_eps01",
     "(result - reference)^2 / (reference^2 + 0.01) in each channel; linear Rec.709, no clamp", false, 0.1F},
    compute_relmse};

inline constexpr MetricInfo kRelMseTrimmed{
    "relmse_eps01_trimmed",
    "1",
    Better::Lower,
    "relmse_eps01 without the 0.1 % of the unmasked pixels (rounded down) whose mean over R, G, B is "
    "largest; linear Rec.709, no clamp, no exposure. For noisy images, always beside the untrimmed "
    "number: what fireflies are dropped from, small faults are dropped from as well",
    kNoMap,
    compute_relmse_trimmed};

}  // namespace orbs::metrics
