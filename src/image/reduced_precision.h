#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include <immintrin.h>

/// Floats with fewer significant bits: 16-bit floats (IEEE 754 binary16, "half"), and 32-bit floats whose
/// last bits are zero.
namespace orbs::image {

/// The largest finite half.
constexpr float kLargestHalf = 65504.0F;

/// The nearest half, ties to even; infinite beyond the largest half. Every machine that the project is
/// compiled for has the instruction (x86-64-v3).
inline std::uint16_t half_bits(float value) {
  return static_cast<std::uint16_t>(
      _mm_cvtsi128_si32(_mm_cvtps_ph(_mm_set_ss(value), _MM_FROUND_TO_NEAREST_INT)));
}

inline float float_of_half(std::uint16_t bits) { return _cvtsh_ss(bits); }

/// `value` rounded to `bits` significant bits (1 to 23), to nearest. Values that fit stay exact, and the
/// result compresses well. Zero, NaN and infinities do not change.
inline float rounded_to_bits(float value, unsigned bits) {
  constexpr unsigned kSignificand = 24;  // one of them is not stored
  if (!std::isfinite(value)) return value;
  const unsigned dropped = kSignificand - bits;
  // A carry out of the significand raises the exponent, which is right: 1.99 becomes 2.
  const auto raised = std::bit_cast<std::uint32_t>(value) + (1U << (dropped - 1));
  return std::bit_cast<float>(raised >> dropped << dropped);
}

}  // namespace orbs::image
