#pragma once

#include <cmath>
#include <concepts>

/// The functions of <cmath> for floats, computed in double and rounded once. Libraries differ in the last bit
/// of their functions for floats (glibc 2.41 has other ones than 2.36), and so would images. The functions
/// for doubles differ by an ulp or two of a double, which moves a rounded float only where the value lies
/// within that of the middle between two floats: once in 10^8 calls. What IEEE 754 defines exactly, as sqrt,
/// needs none of this.
namespace orbs::in_double {

namespace detail {

template <std::floating_point Real, typename Function>
Real rounded(Function function, Real x) {
  return static_cast<Real>(function(static_cast<double>(x)));
}

template <std::floating_point Real, typename Function>
Real rounded(Function function, Real x, Real y) {
  return static_cast<Real>(function(static_cast<double>(x), static_cast<double>(y)));
}

}  // namespace detail

template <std::floating_point Real>
Real sin(Real x) {
  return detail::rounded([](double a) { return std::sin(a); }, x);
}

template <std::floating_point Real>
Real cos(Real x) {
  return detail::rounded([](double a) { return std::cos(a); }, x);
}

template <std::floating_point Real>
Real asin(Real x) {
  return detail::rounded([](double a) { return std::asin(a); }, x);
}

template <std::floating_point Real>
Real acos(Real x) {
  return detail::rounded([](double a) { return std::acos(a); }, x);
}

template <std::floating_point Real>
Real atan2(Real y, Real x) {
  return detail::rounded([](double a, double b) { return std::atan2(a, b); }, y, x);
}

template <std::floating_point Real>
Real exp2(Real x) {
  return detail::rounded([](double a) { return std::exp2(a); }, x);
}

template <std::floating_point Real>
Real cbrt(Real x) {
  return detail::rounded([](double a) { return std::cbrt(a); }, x);
}

template <std::floating_point Real>
Real pow(Real x, Real exponent) {
  return detail::rounded([](double a, double b) { return std::pow(a, b); }, x, exponent);
}

/// In double the squares of floats and their sum neither overflow nor vanish.
inline float hypot(float x, float y) {
  const auto a = static_cast<double>(x);
  const auto b = static_cast<double>(y);
  return static_cast<float>(std::sqrt(a * a + b * b));
}

}  // namespace orbs::in_double
