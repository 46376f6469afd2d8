#include "base/interval.h"

#include "base/student_t.h"

#include <algorithm>

namespace orbs {

Interval student_interval(double value, double error, double degrees, double outside) {
  const double reach = error > 0 ? student_quantile(outside, std::max(1.0, degrees)) * error : 0.0;
  return {value, value - reach, value + reach};
}

}  // namespace orbs
