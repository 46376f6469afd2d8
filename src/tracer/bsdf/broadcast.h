#pragma once

#include "base/vec.h"

#include <array>
#include <type_traits>

namespace orbs::tracer {

/// One value for each of the four wavelengths of a spectral path, in one register.
using Float4 = float __attribute__((vector_size(16)));

inline Float4 float4(const std::array<float, 4>& v) { return Float4{v[0], v[1], v[2], v[3]}; }

inline float mean_of(Float4 v) { return (v[0] + v[1] + v[2] + v[3]) / 4; }
inline float mean_of(Vec3f v) { return (v.x + v.y + v.z) / 3; }

/// Each channel or wavelength by itself.
inline Float4 quotient(Float4 a, Float4 b) { return a / b; }
inline Vec3f quotient(Vec3f a, Vec3f b) { return {a.x / b.x, a.y / b.y, a.z / b.z}; }

/// A factor known at the N wavelengths of a path, in the form that the path carries: RGB paths (N = 1)
/// use the one value for all three channels.
template <typename Value, std::size_t N>
Value broadcast(const std::array<float, N>& each) {
  if constexpr (N == 1)
    return Value{each[0], each[0], each[0]};
  else
    return float4(each);
}

/// The same factor at all wavelengths and in all channels.
template <typename Value>
Value even(float factor) {
  if constexpr (std::is_same_v<Value, Vec3f>)
    return {factor, factor, factor};
  else
    return Value{factor, factor, factor, factor};
}

}  // namespace orbs::tracer
