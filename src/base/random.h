#pragma once

#include <cstdint>

namespace orbs {

/// Mixes two words into one so that every input bit reaches every output bit: the finaliser of SplitMix64
/// (Steele, Lea, Flood 2014) over their combination. All random numbers are functions of their purpose, never
/// of earlier ones, so that a seed gives the same image in any order of work.
constexpr std::uint64_t mix(std::uint64_t a, std::uint64_t b) {
  std::uint64_t z = a * 0x9e3779b97f4a7c15ULL + b + 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

/// A number in [0, 1), never 1, from the upper 53 bits.
constexpr double unit_random(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-53; }

}  // namespace orbs
