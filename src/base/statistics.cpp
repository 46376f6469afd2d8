#include "base/statistics.h"

#include <algorithm>
#include <cmath>

namespace orbs {

namespace {

// Keeps Lentz's divisions defined; far below every term that counts.
constexpr double kTiny = 1e-300;

double not_zero(double value) { return std::fabs(value) < kTiny ? kTiny : value; }

// The continued fraction of the incomplete beta function (Abramowitz and Stegun 26.5.8) by Lentz's method. It
// takes about sqrt(max(a, b)) steps where x < (a + 1) / (a + b + 2).
double beta_fraction(double a, double b, double x) {
  constexpr int kMostSteps = 100000;
  constexpr double kPrecision = 1e-14;
  double c = 1;
  double d = 1 / not_zero(1 - (a + b) * x / (a + 1));
  double fraction = d;
  for (int m = 1; m <= kMostSteps; ++m) {
    const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
    d = 1 / not_zero(1 + even * d);
    c = not_zero(1 + even / c);
    fraction *= d * c;
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
    d = 1 / not_zero(1 + odd * d);
    c = not_zero(1 + odd / c);
    fraction *= d * c;
    if (std::fabs(d * c - 1) < kPrecision) break;
  }
  return fraction;
}

// I_x(a, b), regularised; `y` is 1 - x without its rounding.
double incomplete_beta(double a, double b, double x, double y) {
  if (x <= 0) return 0;
  if (y <= 0) return 1;
  const double logarithm =
      std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log(y);
  if (x < (a + 1) / (a + b + 2)) return std::exp(logarithm) * beta_fraction(a, b, x) / a;
  return 1 - std::exp(logarithm) * beta_fraction(b, a, y) / b;
}

}  // namespace

double student_tail(double t, double degrees) {
  if (std::isinf(t)) return 0;
  const double sum = degrees + t * t;
  return incomplete_beta(degrees / 2, 0.5, degrees / sum, t * t / sum);
}

double student_quantile(double probability, double degrees) {
  double low = 0;
  double high = 1;
  while (student_tail(high, degrees) > probability) high *= 2;
  constexpr int kHalvings = 60;  // more than a double has digits
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (student_tail(middle, degrees) > probability ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

Interval student_interval(double value, double error, double degrees, double outside) {
  const double reach = error > 0 ? student_quantile(outside, std::max(1.0, degrees)) * error : 0.0;
  return {value, value - reach, value + reach};
}

}  // namespace orbs
