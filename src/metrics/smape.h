#pragma once

#include "metrics/metric.h"

#include <cmath>

namespace orbs::metrics {

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

}  // namespace orbs::metrics
