#pragma once

#include "base/vec.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

/// Eight vectors at a time in SIMD registers. Function templates over the vector type V take Vec3f or Vec8,
/// with bit-identical results per lane.
namespace orbs::tracer {

constexpr std::size_t kLanes = 8;

using Float8 = float __attribute__((vector_size(32)));
using Word8 = std::uint32_t __attribute__((vector_size(32)));
using Mask8 = std::int32_t __attribute__((vector_size(32)));  // all bits of a lane, or none

struct Vec8 {
  Float8 x;
  Float8 y;
  Float8 z;

  friend Vec8 operator+(Vec8 a, Vec8 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec8 operator-(Vec8 a, Vec8 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec8 operator*(Vec8 a, Float8 s) { return {a.x * s, a.y * s, a.z * s}; }
};

inline Float8 dot(Vec8 a, Vec8 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

inline float magnitude(float x) { return std::fabs(x); }
inline float with_sign_of(float size, float sign) { return std::copysign(size, sign); }
inline double with_sign_of(double size, double sign) { return std::copysign(size, sign); }

inline Float8 square_root(Float8 x) {
  Float8 out;
  for (std::size_t i = 0; i < kLanes; ++i) out[i] = std::sqrt(x[i]);
  return out;
}

inline Float8 magnitude(Float8 x) {
  Float8 out;
  for (std::size_t i = 0; i < kLanes; ++i) out[i] = std::fabs(x[i]);
  return out;
}

inline Float8 with_sign_of(Float8 size, Float8 sign) {
  Float8 out;
  for (std::size_t i = 0; i < kLanes; ++i) out[i] = std::copysign(size[i], sign[i]);
  return out;
}

inline Vec8 normalised(Vec8 a) { return a * (1.0F / square_root(dot(a, a))); }

inline void set_lane(Vec8& v, std::size_t lane, Vec3f value) {
  v.x[lane] = value.x;
  v.y[lane] = value.y;
  v.z[lane] = value.z;
}
inline Vec3f lane_of(const Vec8& v, std::size_t lane) { return {v.x[lane], v.y[lane], v.z[lane]}; }

}  // namespace orbs::tracer
