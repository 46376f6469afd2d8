#pragma once

#include <cmath>

namespace orbs {

/// Three numbers: a point, a direction or an RGB value. `Real` is double in scene data and float on the
/// tracer's paths.
template <typename Real>
struct Vec3 {
  Real x{};
  Real y{};
  Real z{};

  friend constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr Vec3 operator*(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
  friend constexpr Vec3 operator*(Vec3 a, Real s) { return {a.x * s, a.y * s, a.z * s}; }
  friend constexpr Vec3 operator*(Real s, Vec3 a) { return a * s; }
  friend constexpr Vec3 operator/(Vec3 a, Real s) { return a * (Real(1) / s); }
  friend constexpr bool operator==(Vec3 a, Vec3 b) = default;
  constexpr Vec3& operator+=(Vec3 b) { return *this = *this + b; }
  constexpr Vec3& operator*=(Vec3 b) { return *this = *this * b; }
  constexpr Vec3& operator*=(Real s) { return *this = *this * s; }
};

using Vec3d = Vec3<double>;
using Vec3f = Vec3<float>;

template <typename Real>
struct Vec2 {
  Real x{};
  Real y{};
  friend constexpr bool operator==(Vec2 a, Vec2 b) = default;
};

using Vec2d = Vec2<double>;
using Vec2f = Vec2<float>;

template <typename Real>
constexpr Real dot(Vec3<Real> a, Vec3<Real> b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <typename Real>
constexpr Vec3<Real> cross(Vec3<Real> a, Vec3<Real> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <typename Real>
inline Real length(Vec3<Real> a) {
  return std::sqrt(dot(a, a));
}

/// The unit vector along a, which must not be zero.
template <typename Real>
inline Vec3<Real> normalised(Vec3<Real> a) {
  return a / length(a);
}

/// Radians, 0 to pi; exact where the arc cosine of the unit vectors' product is not: near 0 and pi (W. Kahan,
/// "How Futile are Mindless Assessments of Roundoff", 2006). 0 where one of the two is zero.
inline double angle_between(Vec3d a, Vec3d b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

template <typename Real>
constexpr Real largest(Vec3<Real> a) {
  const Real xy = a.x > a.y ? a.x : a.y;
  return xy > a.z ? xy : a.z;
}

template <typename Real>
Real largest_magnitude(Vec3<Real> a) {
  return largest(Vec3<Real>{std::abs(a.x), std::abs(a.y), std::abs(a.z)});
}

template <typename Real>
bool is_finite(Vec3<Real> a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

template <typename To, typename From>
constexpr Vec3<To> cast(Vec3<From> a) {
  return {static_cast<To>(a.x), static_cast<To>(a.y), static_cast<To>(a.z)};
}

}  // namespace orbs
