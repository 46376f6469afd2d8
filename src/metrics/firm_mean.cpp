#include "metrics/firm_mean.h"

#include <cmath>

namespace orbs::metrics {

std::optional<double> firm_mean(const PairSamples& samples) {
  constexpr double kFirmness = 10;
  double sum = 0;
  double variance = 0;
  for (std::size_t pixel = 0; pixel < samples.included.size(); ++pixel) {
    if (samples.included[pixel] == 0) continue;
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) {
      sum += static_cast<double>(samples.reference[i]);
      variance += variance_at(samples.reference_variance, i);
    }
  }
  if (!(sum > kFirmness * std::sqrt(variance))) return std::nullopt;
  return sum / (3.0 * static_cast<double>(samples.included_count));
}

}  // namespace orbs::metrics
