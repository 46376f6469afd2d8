#include "image/reduced_precision.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace orbs::image {

float rounded_to_bits(float value, unsigned bits) {
  constexpr unsigned kSignificand = 24;  // one of them is not stored
  if (!std::isfinite(value)) return value;
  const unsigned dropped = kSignificand - bits;
  // A carry out of the significand raises the exponent, which is right: 1.99 becomes 2.
  const auto raised = std::bit_cast<std::uint32_t>(value) + (1U << (dropped - 1));
  return std::bit_cast<float>(raised >> dropped << dropped);
}

}  // namespace orbs::image
