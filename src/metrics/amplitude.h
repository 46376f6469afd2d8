#pragma once

#include "base/statistics.h"
#include "metrics/pair_samples.h"

#include <cmath>
#include <vector>

namespace orbs::metrics {

/// Of one block, for an error that is known up to its size: result - reference = amplitude * pattern.
struct AmplitudeSums {
  double product = 0;  // of pattern and difference
  double norm = 0;     // of the pattern with itself, or with what stands for it
};

/// The amplitude by least squares over all blocks, and its noise. Whether there is one at all is tested by
/// the scatter that the blocks have without one. How large it is follows from what it leaves of each block:
/// the former scatter holds the amplitude itself, however certain it is.
struct Amplitude {
  double product = 0;
  double norm = 0;
  PooledVariance of_noise;      // of `product` where the amplitude is zero: the blocks' products squared
  PooledVariance of_remainder;  // of `product` where it is what it is

  double value() const { return product / norm; }

  /// How far noise of this variance moves the amplitude but for the probability `outside`.
  double reach(const PooledVariance& variance, double outside) const {
    return student_quantile(outside, variance.degrees()) * std::sqrt(variance.sum) / norm;
  }
};

/// The variances are 0 where the norm is not above 0: there is no amplitude then.
inline Amplitude amplitude_of(const std::vector<AmplitudeSums>& blocks) {
  Amplitude total;
  for (const auto& block : blocks) {
    total.product += block.product;
    total.norm += block.norm;
  }
  if (!(total.norm > 0)) return total;
  for (const auto& block : blocks) {
    const double left = block.product - total.value() * block.norm;
    total.of_noise.add(block.product * block.product);
    total.of_remainder.add(left * left);
  }
  return total;
}

}  // namespace orbs::metrics
