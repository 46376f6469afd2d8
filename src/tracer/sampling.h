#pragma once

#include "base/vec.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace orbs::tracer {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kInvPi = std::numbers::inv_pi_v<float>;

/// Uniform on the unit disk; area-preserving and continuous (Shirley and Chiu 1997), so that stratified
/// numbers stay so.
inline Vec2f sample_disk(float u, float v) {
  const float a = 2 * u - 1;
  const float b = 2 * v - 1;
  if (a == 0 && b == 0) return {};
  const bool wide = std::abs(a) > std::abs(b);
  const float radius = wide ? a : b;
  const float angle = wide ? (kPi / 4) * (b / a) : kPi / 2 - (kPi / 4) * (a / b);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// Cosine-weighted about +z; pdf = cos / pi.
inline Vec3f sample_cosine(float u, float v) {
  const Vec2f d = sample_disk(u, v);
  // Rounding only: the exact value is not negative.
  return {d.x, d.y, std::sqrt(std::max(0.0F, 1 - d.x * d.x - d.y * d.y))};
}

/// Multiple importance sampling by the power heuristic, exponent 2 (Veach 1997, eq. 9.13), for one sample of
/// each kind.
inline float mis_weight(float pdf, float other_pdf) {
  const float ratio = other_pdf / pdf;
  return 1 / (1 + ratio * ratio);
}

}  // namespace orbs::tracer
