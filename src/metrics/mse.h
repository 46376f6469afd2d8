#pragma once

#include "metrics/metric.h"

namespace orbs::metrics {

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

}  // namespace orbs::metrics
