#pragma once

#include "tracer/geometry/lanes.h"
#include "tracer/sampling/hash.h"
#include "tracer/sampling/sample_dimension.h"

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

/// Point `index` of `count` jittered points (Cook, Porter and Carpenter 1984), four numbers in [0, 1): the
/// numbers that are used as a pair (pixel, point on a light, direction) have a grid of cells, with about as
/// many rows as columns, and the others one interval per point. Each pair and number visits its strata in its
/// own random order, as in pbrt's StratifiedSampler. If the grid has more cells than there are points,
/// a random choice of cells stays empty. `seed` is well mixed.
std::array<float, 4> stratified_point(std::uint32_t seed,
                                      std::uint32_t index,
                                      std::uint32_t count,
                                      SampleDimension dimension);

/// How the points of a block lie: independent random numbers; jittered in strata, as the stratified samplers
/// of pbrt and Mitsuba (stratified_points.h); or Sobol' points (Joe and Kuo 2008, first four dimensions),
/// Owen-scrambled and shuffled by the Laine-Karras hash (Laine and Karras 2011, constants of Vegdahl 2021),
/// after the tabulated form of Burley 2020, "Practical Hash-based Owen Scrambling". Expected values are the
/// same for all three.
enum class Sampler { Independent, Stratified, Sobol };

constexpr std::uint32_t kBlock = 4096;  // points in the table of Sobol' points

struct PointSet {
  Sampler sampler = Sampler::Sobol;
  std::uint32_t count = kBlock;  // points of a whole block; only strata depend on it
};

/// A block of at most kBlock samples of one pixel: an independent copy of the point set.
struct SampleBlock {
  std::uint32_t seed = 0;
  PointSet points;
};

/// The blocks of eight paths.
struct SampleBlocks {
  Word8 seeds{};
  PointSet points;
};

SampleBlock sample_block(std::uint64_t seed, std::uint32_t pixel, std::uint32_t block, PointSet points = {});

/// Point `index` of the block: four numbers in [0, 1), multiples of 2^-24.
std::array<float, 4> draw(SampleBlock block,
                          std::uint32_t index,
                          std::uint32_t bounce,
                          SampleDimension dimension);

/// The same for eight paths.
std::array<Float8, 4> draw(const SampleBlocks& blocks,
                           const Word8& indices,
                           std::uint32_t bounce,
                           SampleDimension dimension);

}  // namespace orbs::tracer
