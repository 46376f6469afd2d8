#include "tracer/sampling/stratified_points.h"

#include "tracer/sampling/independent_points.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace orbs::tracer {

namespace {

// Element `i` of a random permutation of [0, length), without a table (Kensler 2013, "Correlated
// Multi-Jittered Sampling"): a bijection of the next power of two, repeated until the result is below length.
std::uint32_t permuted(std::uint32_t i, std::uint32_t length, std::uint32_t seed) {
  const std::uint32_t mask = std::bit_ceil(length) - 1;
  do {
    i ^= seed;
    i *= 0xe170893dU;
    i ^= seed >> 16;
    i ^= (i & mask) >> 4;
    i ^= seed >> 8;
    i *= 0x0929eb3fU;
    i ^= seed >> 23;
    i ^= (i & mask) >> 1;
    i *= 1U | (seed >> 27);
    i *= 0x6935fa69U;
    i ^= (i & mask) >> 11;
    i *= 0x74dcb303U;
    i ^= (i & mask) >> 2;
    i *= 0x9e501cc3U;
    i ^= (i & mask) >> 2;
    i *= 0xc860a3dfU;
    i &= mask;
    i ^= i >> 5;
  } while (i >= length);
  return (i + seed % length) % length;
}

constexpr float kLargest = 1 - 0x1p-24F;  // rounding could give 1

// Random place within stratum `stratum` of `count`.
float jittered(std::uint32_t stratum, std::uint32_t count, float random) {
  return std::min(kLargest, (static_cast<float>(stratum) + random) / static_cast<float>(count));
}

constexpr int kNoPair = -1;

// The first of the two numbers that are used as a pair; those of PixelAndFirstLight are two pairs.
int pair_of(SampleDimension dimension) {
  switch (dimension) {
    case SampleDimension::PixelAndFirstLight:
    case SampleDimension::Scatter:
      return 0;
    case SampleDimension::Light:
    case SampleDimension::MirroredLight:
      return 1;
    case SampleDimension::LightPick:
    case SampleDimension::Wavelength:
    case SampleDimension::Reradiation:
      break;
  }
  return kNoPair;
}

// Numbers first and first + 1 of the point.
void stratify_pair(std::array<float, 4>& point,
                   std::size_t first,
                   std::uint32_t seed,
                   std::uint32_t index,
                   std::uint32_t count) {
  const auto columns = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(count)));
  const std::uint32_t rows = (count + columns - 1) / columns;
  const std::uint32_t cell =
      permuted(index, columns * rows, hash(seed + static_cast<std::uint32_t>(first) + 1U));
  point[first] = jittered(cell % columns, columns, point[first]);
  point[first + 1] = jittered(cell / columns, rows, point[first + 1]);
}

void stratify_single(std::array<float, 4>& point,
                     std::size_t d,
                     std::uint32_t seed,
                     std::uint32_t index,
                     std::uint32_t count) {
  point[d] =
      jittered(permuted(index, count, hash(seed + static_cast<std::uint32_t>(d) + 1U)), count, point[d]);
}

}  // namespace

std::array<float, 4> stratified_point(std::uint32_t seed,
                                      std::uint32_t index,
                                      std::uint32_t count,
                                      SampleDimension dimension) {
  auto point = independent_point(seed, index);
  if (dimension == SampleDimension::PixelAndFirstLight) {
    stratify_pair(point, 0, seed, index, count);
    stratify_pair(point, 2, seed, index, count);
    return point;
  }
  const int pair = pair_of(dimension);
  for (int d = 0; d < 4; ++d) {
    if (pair != kNoPair && (d == pair || d == pair + 1)) continue;
    stratify_single(point, static_cast<std::size_t>(d), seed, index, count);
  }
  if (pair != kNoPair) stratify_pair(point, static_cast<std::size_t>(pair), seed, index, count);
  return point;
}

}  // namespace orbs::tracer
