#pragma once

#include "tracer/sampling/hash.h"

#include <array>
#include <cstdint>

namespace orbs::tracer {

/// Number `counter` of an independent sequence: in [0, 1), a multiple of 2^-24.
inline float independent_number(std::uint32_t seed, std::uint32_t counter) {
  return static_cast<float>(static_cast<std::int32_t>(hash(seed ^ hash(counter + 1U)) >> 8)) * 0x1p-24F;
}

/// Four independent random numbers; `seed` is well mixed.
inline std::array<float, 4> independent_point(std::uint32_t seed, std::uint32_t index) {
  return {independent_number(seed, 4 * index), independent_number(seed, 4 * index + 1),
          independent_number(seed, 4 * index + 2), independent_number(seed, 4 * index + 3)};
}

}  // namespace orbs::tracer
