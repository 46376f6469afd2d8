#include "tracer/sampling/sampler.h"

#include "base/random.h"
#include "tracer/sampling/hash.h"
#include "tracer/sampling/independent_points.h"
#include "tracer/sampling/stratified_points.h"

namespace orbs::tracer {

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

SampleBlock sample_block(std::uint64_t seed, std::uint32_t pixel, std::uint32_t replicate, PointSet points) {
  return {static_cast<std::uint32_t>(mix(seed, (std::uint64_t{pixel} << 32) | replicate)), points};
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
