#pragma once

#include "base/vec.h"
#include "scene/shapes/enclosure.h"
#include "scene/shapes/expression.h"

#include <cmath>

/// Automatic differentiation, forward mode: a value with its derivative (Griewank, Walther 2008, Evaluating
/// Derivatives, 3.1).
namespace orbs::scene {

template <typename V, typename D>
struct Dual {
  V value{};
  D derivative{};
};

/// f along a ray and its derivative by the ray's parameter, both as enclosures. That of a kink (abs, min,
/// max) is one of Clarke's generalised derivative, for which the mean value theorem holds as well.
using Slope = Dual<Enclosure, Enclosure>;
/// f at a point and its gradient.
using Gradient = Dual<double, Vec3d>;

template <>
inline Slope constant<Slope>(double value) {
  return {Enclosure(value), Enclosure(0)};
}
template <>
inline Gradient constant<Gradient>(double value) {
  return {value, {}};
}

/// What the derivative is times, of the outer functions that are not smooth or not defined everywhere.
inline double sign_of(double a) { return a < 0 ? -1 : 1; }
inline Enclosure sign_of(const Enclosure& a) {
  return {a.low < 0 ? -1.0 : 1.0, a.high > 0 || a.low >= 0 ? 1.0 : -1.0};
}
inline double power_slope(double a, double exponent) { return exponent * std::pow(a, exponent - 1); }
inline Enclosure power_slope(const Enclosure& a, double exponent) {
  // Where the power has no value, it has no slope that would bound it.
  if (!(a.low >= 0)) return everything();
  return Enclosure(exponent) * real_power(a, exponent - 1);
}

/// -1 where a is surely smaller, 1 where b is, 0 where that depends.
inline int order_of(double a, double b) { return a < b ? -1 : 1; }
inline int order_of(const Enclosure& a, const Enclosure& b) {
  return a.high < b.low ? -1 : (b.high < a.low ? 1 : 0);
}
inline Vec3d hull(Vec3d a, Vec3d) { return a; }

template <typename V, typename D>
Dual<V, D> chain(const V& value, const V& slope, const Dual<V, D>& inner) {
  return {value, slope * inner.derivative};
}

template <typename V, typename D>
Dual<V, D> operator-(const Dual<V, D>& a) {
  return {-a.value, -a.derivative};
}
template <typename V, typename D>
Dual<V, D> operator+(const Dual<V, D>& a, const Dual<V, D>& b) {
  return {a.value + b.value, a.derivative + b.derivative};
}
template <typename V, typename D>
Dual<V, D> operator-(const Dual<V, D>& a, const Dual<V, D>& b) {
  return {a.value - b.value, a.derivative - b.derivative};
}
template <typename V, typename D>
Dual<V, D> operator*(const Dual<V, D>& a, const Dual<V, D>& b) {
  return {a.value * b.value, b.value * a.derivative + a.value * b.derivative};
}
template <typename V, typename D>
Dual<V, D> operator/(const Dual<V, D>& a, const Dual<V, D>& b) {
  const V one = constant<V>(1);
  const V quotient = a.value / b.value;
  return {quotient, (one / b.value) * (a.derivative - quotient * b.derivative)};
}
template <typename V, typename D>
Dual<V, D> integer_power(const Dual<V, D>& a, int n) {
  const V slope = n == 0 ? constant<V>(0) : constant<V>(n) * integer_power(a.value, n - 1);
  return chain(integer_power(a.value, n), slope, a);
}
template <typename V, typename D>
Dual<V, D> real_power(const Dual<V, D>& a, double exponent) {
  return chain(real_power(a.value, exponent), power_slope(a.value, exponent), a);
}
template <typename V, typename D>
Dual<V, D> sqrt(const Dual<V, D>& a) {
  using std::sqrt;
  return chain(sqrt(a.value), power_slope(a.value, 0.5), a);
}
template <typename V, typename D>
Dual<V, D> log(const Dual<V, D>& a) {
  using std::log;
  return chain(log(a.value), constant<V>(1) / a.value, a);
}
template <typename V, typename D>
Dual<V, D> exp(const Dual<V, D>& a) {
  using std::exp;
  const V value = exp(a.value);
  return chain(value, value, a);
}
template <typename V, typename D>
Dual<V, D> sin(const Dual<V, D>& a) {
  using std::cos, std::sin;
  return chain(sin(a.value), cos(a.value), a);
}
template <typename V, typename D>
Dual<V, D> cos(const Dual<V, D>& a) {
  using std::cos, std::sin;
  return chain(cos(a.value), -sin(a.value), a);
}
template <typename V, typename D>
Dual<V, D> abs(const Dual<V, D>& a) {
  using std::abs;
  return chain(abs(a.value), sign_of(a.value), a);
}
template <typename V, typename D>
D derivative_of_choice(int order, const D& first, const D& second) {
  return order == 0 ? hull(first, second) : (order < 0 ? first : second);
}
template <typename V, typename D>
Dual<V, D> smaller(const Dual<V, D>& a, const Dual<V, D>& b) {
  const int order = order_of(a.value, b.value);
  return {smaller(a.value, b.value), derivative_of_choice<V>(order, a.derivative, b.derivative)};
}
template <typename V, typename D>
Dual<V, D> larger(const Dual<V, D>& a, const Dual<V, D>& b) {
  const int order = order_of(a.value, b.value);
  return {larger(a.value, b.value), derivative_of_choice<V>(order, b.derivative, a.derivative)};
}

}  // namespace orbs::scene
