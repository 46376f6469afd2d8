#include "tracer/sampling/sampler.h"

#include "base/random.h"
#include "tracer/sampling/hash.h"

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
    case SampleDimension::Lens:
      return 0;
    case SampleDimension::Light:
    case SampleDimension::MirroredLight:
      return 1;
    case SampleDimension::LightPick:
    case SampleDimension::Wavelength:
    case SampleDimension::Time:
    case SampleDimension::Blend:
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

namespace {

// Only shifts and masks, so that the compiler keeps the four dimensions of a point in one vector register.
template <typename Word>
constexpr Word reverse_bits(Word x) {
  x = (x << 16) | (x >> 16);
  x = ((x & 0x00ff00ffU) << 8) | ((x >> 8) & 0x00ff00ffU);
  x = ((x & 0x0f0f0f0fU) << 4) | ((x >> 4) & 0x0f0f0f0fU);
  x = ((x & 0x33333333U) << 2) | ((x >> 2) & 0x33333333U);
  return ((x & 0x55555555U) << 1) | ((x >> 1) & 0x55555555U);
}

// Owen scrambling of a bit-reversed number: a hash of the lower bits, which are the more significant ones
// before the reversal, decides whether each bit is flipped.
template <typename Word>
constexpr Word scramble_reversed(Word x, Word seed) {
  x ^= x * 0x3d20adeaU;
  x += seed;
  x *= (seed >> 16) | 1U;
  x ^= x * 0x05526c56U;
  x ^= x * 0x53a22864U;
  return x;
}

// The seed is well mixed already, so one multiplication suffices to decorrelate the dimensions.
template <typename Word>
constexpr Word seed_of_dimension(Word seed, std::uint32_t dimension) {
  const Word x = (seed + (dimension + 1U) * 0x9e3779b9U) * 0x2c1b3c6dU;
  return x ^ (x >> 15);
}

using Table = std::array<std::array<std::uint32_t, 4>, kBlock>;

// Direction numbers of dimensions 1 to 4 by the recurrence of Joe and Kuo 2008, with degree s, coefficients a
// and initial numbers m.
constexpr std::array<std::array<std::uint32_t, 32>, 4> direction_numbers() {
  struct Polynomial {
    std::uint32_t s;
    std::uint32_t a;
    std::array<std::uint32_t, 3> m;
  };
  constexpr std::array<Polynomial, 3> kPolynomials{{{1, 0, {1, 0, 0}}, {2, 1, {1, 3, 0}}, {3, 1, {1, 3, 1}}}};
  std::array<std::array<std::uint32_t, 32>, 4> v{};
  for (std::uint32_t i = 0; i < 32; ++i) v[0][i] = 1U << (31 - i);
  for (std::size_t d = 0; d < kPolynomials.size(); ++d) {
    const auto& p = kPolynomials[d];
    auto& row = v[d + 1];
    for (std::uint32_t i = 0; i < 32; ++i) {
      if (i < p.s) {
        row[i] = p.m[i] << (31 - i);
        continue;
      }
      row[i] = row[i - p.s] ^ (row[i - p.s] >> p.s);
      for (std::uint32_t k = 1; k < p.s; ++k)
        if ((p.a >> (p.s - 1 - k)) & 1U) row[i] ^= row[i - k];
    }
  }
  return v;
}

Table make_table() {
  constexpr auto kDirections = direction_numbers();
  Table table{};
  for (std::uint32_t point = 0; point < kBlock; ++point)
    for (std::size_t d = 0; d < 4; ++d) {
      std::uint32_t x = 0;
      for (std::uint32_t bit = 0; bit < 12; ++bit)
        if ((point >> bit) & 1U) x ^= kDirections[d][bit];
      table[point][d] = reverse_bits(x);
    }
  return table;
}

const Table kTable = make_table();

}  // namespace

SampleBlock sample_block(std::uint64_t seed, std::uint32_t pixel, std::uint32_t block, PointSet points) {
  return {static_cast<std::uint32_t>(mix(seed, (std::uint64_t{pixel} << 32) | block)), points};
}

namespace {

// Four numbers of 24 bits, because more could round to 1.0f.
std::array<float, 4> sobol_point(std::uint32_t seed, std::uint32_t index) {
  const std::uint32_t shuffled = reverse_bits(scramble_reversed(reverse_bits(index), seed));
  std::array<std::uint32_t, 4> bits = kTable[shuffled & (kBlock - 1)];
  for (std::uint32_t d = 0; d < 4; ++d)
    bits[d] = reverse_bits(scramble_reversed(bits[d], seed_of_dimension(seed, d)));
  std::array<float, 4> out{};
  for (std::uint32_t d = 0; d < 4; ++d)
    out[d] = static_cast<float>(static_cast<std::int32_t>(bits[d] >> 8)) * 0x1p-24F;
  return out;
}

std::array<Float8, 4> sobol_points(const Word8& seed, const Word8& indices) {
  const Word8 shuffled = reverse_bits(scramble_reversed(reverse_bits(indices), seed)) & (kBlock - 1);
  std::array<Word8, 4> bits;
  for (std::size_t lane = 0; lane < kLanes; ++lane)
    for (std::size_t d = 0; d < 4; ++d) bits[d][lane] = kTable[shuffled[lane]][d];
  std::array<Float8, 4> out;
  for (std::uint32_t d = 0; d < 4; ++d) {
    const Word8 scrambled = reverse_bits(scramble_reversed(bits[d], seed_of_dimension(seed, d)));
    out[d] =
        __builtin_convertvector(reinterpret_cast<const Mask8&>(scrambled) >> 8 & 0xffffff, Float8) * 0x1p-24F;
  }
  return out;
}

template <typename Word>
Word seed_of_set(Word block_seed, std::uint32_t bounce, SampleDimension dimension) {
  return hash(block_seed ^ hash(bounce * 4U + static_cast<std::uint32_t>(dimension) + 1U));
}

}  // namespace

std::array<float, 4> draw(SampleBlock block,
                          std::uint32_t index,
                          std::uint32_t bounce,
                          SampleDimension dimension) {
  const std::uint32_t seed = seed_of_set(block.seed, bounce, dimension);
  switch (block.points.sampler) {
    case Sampler::Independent:
      return independent_point(seed, index);
    case Sampler::Stratified:
      return stratified_point(seed, index, block.points.count, dimension);
    case Sampler::Sobol:
      break;
  }
  return sobol_point(seed, index);
}

std::array<Float8, 4> draw(const SampleBlocks& blocks,
                           const Word8& indices,
                           std::uint32_t bounce,
                           SampleDimension dimension) {
  const Word8 seeds = seed_of_set(blocks.seeds, bounce, dimension);
  if (blocks.points.sampler == Sampler::Sobol) return sobol_points(seeds, indices);
  std::array<Float8, 4> out;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const auto point = blocks.points.sampler == Sampler::Independent
                           ? independent_point(seeds[lane], indices[lane])
                           : stratified_point(seeds[lane], indices[lane], blocks.points.count, dimension);
    for (std::size_t d = 0; d < 4; ++d) out[d][lane] = point[d];
  }
  return out;
}

}  // namespace orbs::tracer
