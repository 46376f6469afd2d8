#include "adapters/masking.h"

#include <cmath>
#include <numbers>

namespace orbs::adapters {

double masking_difference(double alpha) {
  const double slope = alpha * std::tan(80 * std::numbers::pi / 180);
  const double lambda = (std::sqrt(1 + slope * slope) - 1) / 2;
  return lambda * lambda / (1 + 2 * lambda);  // (1 + L)^2 / (1 + 2 L) - 1
}

}  // namespace orbs::adapters
