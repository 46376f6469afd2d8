#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

/// Interval arithmetic with outward rounding: the enclosure of a result holds all values that the operation
/// has on the numbers of the operands (Moore, Kearfott, Cloud 2009, Introduction to Interval Analysis).
namespace orbs::scene {

/// The numbers from `low` to `high`, infinite ends included. Empty where not low <= high.
struct Enclosure {
  double low = 0;
  double high = 0;
  Enclosure() = default;
  explicit Enclosure(double value) : low(value), high(value) {}
  Enclosure(double from, double to) : low(from), high(to) {}
};

inline bool is_empty(const Enclosure& a) { return !(a.low <= a.high); }
inline bool holds_zero(const Enclosure& a) { return a.low <= 0 && a.high >= 0; }
inline bool is_bounded(const Enclosure& a) { return std::isfinite(a.low) && std::isfinite(a.high); }

inline Enclosure everything() {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  return {-kInf, kInf};
}
inline Enclosure nothing() {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  return {kInf, -kInf};
}

/// Numbers below and above all that round to x, or that x is off by less than `steps` halves of its last
/// digit. |x| 2^-52 is one to two units in the last place; the smallest denormal is for results near zero.
/// What rounded to infinity may be as small as the largest double.
inline double below(double x, double steps = 1) {
  const double finite = std::min(x, std::numeric_limits<double>::max());
  return finite - (std::abs(finite) * (steps * 0x1p-52) + std::numeric_limits<double>::denorm_min());
}
inline double above(double x, double steps = 1) {
  const double finite = std::max(x, std::numeric_limits<double>::lowest());
  return finite + (std::abs(finite) * (steps * 0x1p-52) + std::numeric_limits<double>::denorm_min());
}

inline Enclosure operator-(const Enclosure& a) { return {-a.high, -a.low}; }
inline Enclosure operator+(const Enclosure& a, const Enclosure& b) {
  return {below(a.low + b.low), above(a.high + b.high)};
}
inline Enclosure operator-(const Enclosure& a, const Enclosure& b) {
  return {below(a.low - b.high), above(a.high - b.low)};
}

/// Both operands as they are needed where an end is infinite: zero times infinity is zero here, as an
/// infinite end stands for all finite numbers.
Enclosure multiply_unbounded(const Enclosure& a, const Enclosure& b);

inline Enclosure operator*(const Enclosure& a, const Enclosure& b) {
  const double p = a.low * b.low;
  const double q = a.low * b.high;
  const double r = a.high * b.low;
  const double s = a.high * b.high;
  if (!std::isfinite(p + q + r + s)) return multiply_unbounded(a, b);
  return {below(std::min(std::min(p, q), std::min(r, s))), above(std::max(std::max(p, q), std::max(r, s)))};
}

Enclosure operator/(const Enclosure& a, const Enclosure& b);
/// Powers other than the square, which most formulas are made of.
Enclosure higher_power(const Enclosure& a, int n);

inline Enclosure integer_power(const Enclosure& a, int n) {
  if (n == 1) return a;
  if (n != 2 || is_empty(a)) return higher_power(a, n);
  const double p = a.low * a.low;
  const double q = a.high * a.high;
  const double low = holds_zero(a) ? 0 : std::max(0.0, below(std::min(p, q)));
  return {low, above(std::max(p, q))};
}
/// Of the numbers of a that are not negative, empty without any; of all numbers where the exponent is whole.
Enclosure real_power(const Enclosure& a, double exponent);
Enclosure sqrt(const Enclosure& a);
/// Of the positive numbers of a; empty without any.
Enclosure log(const Enclosure& a);
Enclosure exp(const Enclosure& a);
Enclosure sin(const Enclosure& a);
Enclosure cos(const Enclosure& a);
Enclosure abs(const Enclosure& a);
Enclosure smaller(const Enclosure& a, const Enclosure& b);
Enclosure larger(const Enclosure& a, const Enclosure& b);
Enclosure hull(const Enclosure& a, const Enclosure& b);

}  // namespace orbs::scene
