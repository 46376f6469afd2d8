#pragma once

#include <cstdint>

#include <immintrin.h>

namespace orbs::image {

/// Largest finite 16-bit float (IEEE 754 binary16).
constexpr float kLargestHalf = 65504.0F;

/// Nearest half, ties to even; beyond the largest half infinite. Every machine that the project is compiled
/// for has the instruction (x86-64-v3).
inline std::uint16_t half_bits(float value) {
  return static_cast<std::uint16_t>(
      _mm_cvtsi128_si32(_mm_cvtps_ph(_mm_set_ss(value), _MM_FROUND_TO_NEAREST_INT)));
}

inline float float_of_half(std::uint16_t bits) { return _cvtsh_ss(bits); }

}  // namespace orbs::image
