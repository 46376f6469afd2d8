#include "scene/shapes/enclosure.h"

#include <numbers>

namespace orbs::scene {

namespace {

// glibc's sin, cos, exp, log and pow are off by at most 1 ulp (glibc manual, "Errors in Math Functions").
constexpr double kLibrary = 4;

// An infinite end stands for all finite numbers, of which each times zero is zero.
double product(double a, double b) { return a == 0 || b == 0 ? 0 : a * b; }

// a^n of a number a >= 0, outwards: each of the products rounds once.
double power_below(double a, int n) {
  double result = 1;
  for (int i = 0; i < n; ++i) result = i == 0 ? a : below(result * a);
  return std::max(result, 0.0);
}
double power_above(double a, int n) {
  double result = 1;
  for (int i = 0; i < n; ++i) result = i == 0 ? a : above(result * a);
  return result;
}

Enclosure odd_power(const Enclosure& a, int n) {
  const auto low = [&](double x) { return x >= 0 ? power_below(x, n) : -power_above(-x, n); };
  const auto high = [&](double x) { return x >= 0 ? power_above(x, n) : -power_below(-x, n); };
  return {low(a.low), high(a.high)};
}

constexpr double kFarthest = 1e9;  // beyond, the margin of may_hold_phase hides the period

// Whether a number of the form phase + 2 pi k lies in a, or may lie there as far as rounding tells.
bool may_hold_phase(const Enclosure& a, double phase) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const double margin = 1e-12 + 1e-15 * std::max(std::abs(a.low), std::abs(a.high));
  return std::floor((a.high - phase) / kTurn + margin) != std::floor((a.low - phase) / kTurn - margin);
}

}  // namespace

Enclosure multiply_unbounded(const Enclosure& a, const Enclosure& b) {
  if (is_empty(a) || is_empty(b)) return nothing();
  const double p = product(a.low, b.low);
  const double q = product(a.low, b.high);
  const double r = product(a.high, b.low);
  const double s = product(a.high, b.high);
  return {below(std::min(std::min(p, q), std::min(r, s))), above(std::max(std::max(p, q), std::max(r, s)))};
}

Enclosure operator/(const Enclosure& a, const Enclosure& b) {
  if (is_empty(a) || is_empty(b)) return nothing();
  if (b.low > 0 || b.high < 0) return a * Enclosure{below(1 / b.high), above(1 / b.low)};
  return everything();
}

Enclosure higher_power(const Enclosure& a, int n) {
  if (is_empty(a)) return a;
  if (n < 0) return Enclosure(1) / integer_power(a, -n);
  if (n == 0) return Enclosure(1);
  if (n % 2 == 1) return odd_power(a, n);
  const Enclosure m = abs(a);
  return {power_below(m.low, n), power_above(m.high, n)};
}

namespace {

// Whole powers that are too high for products (power_below): pow has values for negative numbers, too.
Enclosure high_whole_power(const Enclosure& a, double exponent) {
  if (exponent < 0) return Enclosure(1) / high_whole_power(a, -exponent);
  const bool is_odd = std::fmod(exponent, 2) != 0;
  const Enclosure base = is_odd ? a : abs(a);
  const double low = std::pow(base.low, exponent);
  const double high = std::pow(base.high, exponent);
  return {is_odd ? below(low, kLibrary) : std::max(0.0, below(low, kLibrary)), above(high, kLibrary)};
}

}  // namespace

Enclosure real_power(const Enclosure& a, double exponent) {
  if (is_empty(a)) return a;
  if (exponent == std::round(exponent)) return high_whole_power(a, exponent);
  if (!(a.high >= 0)) return nothing();
  const double low = std::max(a.low, 0.0);
  const double p = std::pow(low, exponent);
  const double q = std::pow(a.high, exponent);
  return {std::max(0.0, below(std::min(p, q), kLibrary)), above(std::max(p, q), kLibrary)};
}

Enclosure sqrt(const Enclosure& a) {
  if (!(a.high >= 0)) return nothing();
  return {std::max(0.0, below(std::sqrt(std::max(a.low, 0.0)))), above(std::sqrt(a.high))};
}

Enclosure log(const Enclosure& a) {
  if (!(a.high > 0)) return nothing();
  // log(0) is -infinity; close to 1 the digits of the result start far below those of 1, as do its steps.
  return {below(std::log(std::max(a.low, 0.0)), kLibrary), above(std::log(a.high), kLibrary)};
}

Enclosure exp(const Enclosure& a) {
  if (is_empty(a)) return a;
  return {std::max(0.0, below(std::exp(a.low), kLibrary)), above(std::exp(a.high), kLibrary)};
}

Enclosure sin(const Enclosure& a) {
  if (is_empty(a)) return a;
  if (!(a.low > -kFarthest && a.high < kFarthest) || a.high - a.low >= 2 * std::numbers::pi) return {-1, 1};
  const double p = std::sin(a.low);
  const double q = std::sin(a.high);
  const double low = may_hold_phase(a, -std::numbers::pi / 2) ? -1 : below(std::min(p, q), kLibrary);
  const double high = may_hold_phase(a, std::numbers::pi / 2) ? 1 : above(std::max(p, q), kLibrary);
  return {std::max(-1.0, low), std::min(1.0, high)};
}

Enclosure cos(const Enclosure& a) {
  if (is_empty(a)) return a;
  if (!(a.low > -kFarthest && a.high < kFarthest) || a.high - a.low >= 2 * std::numbers::pi) return {-1, 1};
  const double p = std::cos(a.low);
  const double q = std::cos(a.high);
  const double low = may_hold_phase(a, std::numbers::pi) ? -1 : below(std::min(p, q), kLibrary);
  const double high = may_hold_phase(a, 0) ? 1 : above(std::max(p, q), kLibrary);
  return {std::max(-1.0, low), std::min(1.0, high)};
}

Enclosure abs(const Enclosure& a) {
  if (is_empty(a)) return a;
  if (a.low >= 0) return a;
  if (a.high <= 0) return -a;
  return {0, std::max(-a.low, a.high)};
}

Enclosure smaller(const Enclosure& a, const Enclosure& b) {
  if (is_empty(a) || is_empty(b)) return nothing();
  return {std::min(a.low, b.low), std::min(a.high, b.high)};
}

Enclosure larger(const Enclosure& a, const Enclosure& b) {
  if (is_empty(a) || is_empty(b)) return nothing();
  return {std::max(a.low, b.low), std::max(a.high, b.high)};
}

Enclosure hull(const Enclosure& a, const Enclosure& b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

}  // namespace orbs::scene
