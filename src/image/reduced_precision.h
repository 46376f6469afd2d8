#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

/// Floats with fewer significant bits: 16-bit floats (IEEE 754 binary16, "half"), and 32-bit floats whose
/// last bits are zero.
namespace orbs::image {

/// The largest finite half.
constexpr float kLargestHalf = 65504.0F;

namespace detail {

constexpr std::uint32_t kInfinity = 0x7f800000;     // as the bits of a float
constexpr std::uint32_t kNoHalf = 0x47800000;       // 2^16: a half has no exponent as large
constexpr std::uint32_t kLeastNormal = 0x38800000;  // 2^-14: below it a half is a multiple of 2^-24
constexpr std::uint32_t kBias = (127 - 15) << 23;   // between the exponents of the two
constexpr unsigned kDropped = 23 - 10;              // bits of a float's significand that a half lacks
constexpr std::uint32_t kQuiet = 0x200;             // of a half that is no number

}  // namespace detail

/// The nearest half, ties to even; infinite beyond the largest half. IEEE 754, 5.4.2, in whole numbers: not
/// every compiler has a type for halves, nor every processor the instruction.
inline std::uint16_t half_bits(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  const std::uint32_t sign = bits >> 16 & 0x8000;
  const std::uint32_t size = bits & 0x7fffffff;
  std::uint32_t half = 0;
  if (size > detail::kInfinity) {
    half = 0x7c00 | detail::kQuiet | (size >> detail::kDropped & 0x3ff);
  } else if (size >= detail::kNoHalf) {
    half = 0x7c00;
  } else if (size < detail::kLeastNormal) {
    // The floats about 1/2 are multiples of 2^-24, too: the sum is rounded as the half must be.
    half =
        std::bit_cast<std::uint32_t>(std::bit_cast<float>(size) + 0.5F) - std::bit_cast<std::uint32_t>(0.5F);
  } else {
    const std::uint32_t to_even = size >> detail::kDropped & 1;
    half = (size - detail::kBias + (1U << (detail::kDropped - 1)) - 1 + to_even) >> detail::kDropped;
  }
  return static_cast<std::uint16_t>(sign | half);
}

inline float float_of_half(std::uint16_t bits) {
  const std::uint32_t sign = (bits & 0x8000U) << 16;
  const std::uint32_t size = bits & 0x7fffU;
  if (size < 0x400)  // a multiple of 2^-24
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(static_cast<float>(size) * 0x1p-24F) | sign);
  const std::uint32_t moved = size << detail::kDropped;
  if (size < 0x7c00) return std::bit_cast<float>((moved + detail::kBias) | sign);
  const std::uint32_t quiet = size > 0x7c00 ? detail::kQuiet << detail::kDropped : 0;
  return std::bit_cast<float>(detail::kInfinity | moved | quiet | sign);
}

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
