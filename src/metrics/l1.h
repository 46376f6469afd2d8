#pragma once

#include "metrics/metric.h"

#include <cmath>

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

}  // namespace orbs::metrics
