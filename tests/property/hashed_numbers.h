#pragma once

#include "base/random.h"

#include <array>
#include <cstdint>

/// Random numbers as a function of their place, the same on every machine.
namespace orbs::tests {

/// Number d of set i, in [0, 1).
inline float uniform(std::uint64_t i, std::uint64_t d) {
  return static_cast<float>(mix(i, d) >> 40) * 0x1p-24F;
}

inline std::array<float, 4> four_uniform(std::uint64_t i) {
  return {uniform(i, 0), uniform(i, 1), uniform(i, 2), uniform(i, 3)};
}

}  // namespace orbs::tests
