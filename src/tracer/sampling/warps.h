#pragma once

#include "base/vec.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace orbs::tracer {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kInvPi = std::numbers::inv_pi_v<float>;

/// A number in [0, 1) with the digits of both: `more`, in [0, 1), divides the step of a 24-bit number.
inline double with_more_digits(float u, float more) {
  return std::min(static_cast<double>(u) + static_cast<double>(more) * 0x1p-24, 0x1.fffffffffffffp-1);
}

/// (cos x, sin x) for |x| <= pi / 4 by their Taylor series; the truncation errors are below 3e-8 and 2e-9,
/// half an ulp.
inline Vec2f cos_sin_of_eighth(float x) {
  const float x2 = x * x;
  const float sine =
      x * (1 + x2 * (-1.0F / 6 + x2 * (1.0F / 120 + x2 * (-1.0F / 5040 + x2 * (1.0F / 362880)))));
  const float cosine = 1 + x2 * (-0.5F + x2 * (1.0F / 24 + x2 * (-1.0F / 720 + x2 * (1.0F / 40320))));
  return {cosine, sine};
}

/// Uniform on the unit disk by the concentric map (Shirley and Chiu 1997), which preserves stratification.
inline Vec2f sample_disk(float u, float v) {
  const float a = 2 * u - 1;
  const float b = 2 * v - 1;
  if (a == 0 && b == 0) return {};
  const bool wide = std::abs(a) > std::abs(b);
  const float radius = wide ? a : b;
  const Vec2f direction = cos_sin_of_eighth((kPi / 4) * (wide ? b / a : a / b));
  return wide ? Vec2f{radius * direction.x, radius * direction.y}
              : Vec2f{radius * direction.y, radius * direction.x};
}

/// Cosine-weighted about +z; pdf = cos / pi.
inline Vec3f sample_cosine(float u, float v) {
  const Vec2f d = sample_disk(u, v);
  // Rounding only: the exact value is not negative.
  return {d.x, d.y, std::sqrt(std::max(0.0F, 1 - d.x * d.x - d.y * d.y))};
}

/// Barycentric coordinates of the second and third corner, uniform by area (Heitz 2019, "A Low-Distortion Map
/// Between Triangle and Square").
inline Vec2f triangle_point(Vec2f uv) {
  return uv.y > uv.x ? Vec2f{uv.x / 2, uv.y - uv.x / 2} : Vec2f{uv.x - uv.y / 2, uv.y / 2};
}

/// Weight of the power heuristic with exponent 2 for one sample of each technique (Veach 1997, eq. 9.13).
template <typename Real>
Real mis_weight(Real pdf, Real other_pdf) {
  const Real ratio = other_pdf / pdf;
  return 1.0F / (1.0F + ratio * ratio);
}

/// The same for three techniques.
template <typename Real>
Real mis_weight(Real pdf, Real other_pdf, Real third_pdf) {
  const Real other = other_pdf / pdf;
  const Real third = third_pdf / pdf;
  return 1.0F / (1.0F + other * other + third * third);
}

}  // namespace orbs::tracer
