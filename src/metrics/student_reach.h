#pragma once

#include "base/statistics.h"
#include "metrics/pair_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace orbs::metrics {

/// Student's quantiles for whole degrees of freedom, rounded down, which makes them larger: one for each
/// window or line would cost more than the windows.
class StudentReach {
 public:
  explicit StudentReach(double false_alarms) : false_alarms_(false_alarms) {}

  double false_alarms() const { return false_alarms_; }

  double of(const PooledVariance& variance) {
    const auto degrees = static_cast<std::size_t>(std::clamp(variance.degrees(), 1.0, kMost));
    return quantile(degrees) * std::sqrt(variance.sum);
  }

  /// Times the standard deviation not more than the reach with any degrees of freedom. The quantile falls
  /// with them, but for what its rounding makes.
  double least_quantile() {
    constexpr double kRounding = 1e-9;
    return (1 - kRounding) * quantile(static_cast<std::size_t>(kMost));
  }

 private:
  static constexpr double kMost = 255;

  double quantile(std::size_t degrees) {
    double& quantile = quantiles_.at(degrees);
    if (quantile == 0) quantile = student_quantile(false_alarms_, static_cast<double>(degrees));
    return quantile;
  }

  double false_alarms_;
  std::array<double, 256> quantiles_{};
};

}  // namespace orbs::metrics
