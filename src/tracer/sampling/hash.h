#pragma once

#include <cstdint>

namespace orbs::tracer {

/// 32-bit finaliser with low bias (Wellons 2018, "Prospecting for hash functions", triple32 family's
/// two-round form). Word is std::uint32_t or a vector of eight.
template <typename Word>
constexpr Word hash(Word x) {
  x ^= x >> 16;
  x *= 0x7feb352dU;
  x ^= x >> 15;
  x *= 0x846ca68bU;
  x ^= x >> 16;
  return x;
}

}  // namespace orbs::tracer
