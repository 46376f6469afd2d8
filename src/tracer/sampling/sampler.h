#pragma once

#include "tracer/geometry/lanes.h"

#include <array>
#include <cstdint>

namespace orbs::tracer {

/// The use of a set of four random numbers. The numbers are a function of (seed, pixel, replicate, sample,
/// bounce, dimension), so that switching one use on or off does not shift the others. Sets are numbered 4
/// bounce + dimension: a set drawn at bounce 0 alone needs a dimension that no other has at bounce 0, and a
/// set drawn at every bounce needs one that is unique modulo 4.
enum class SampleDimension : std::uint32_t {
  PixelAndFirstLight,  // at bounce 0 alone
  LightPick,           // at bounce 0 alone
  Light,
  Scatter,
  MirroredLight,
  Wavelength,             // at bounce 0 alone
  Reradiation = 1U << 31  // the four of each bounce are taken; this lies beyond those of 2^29 bounces
};

/// A block of at most kBlock samples of one pixel: an independently scrambled copy of the point set.
struct SampleBlock {
  std::uint32_t seed = 0;
};

constexpr std::uint32_t kBlock = 4096;  // points in the table

SampleBlock sample_block(std::uint64_t seed, std::uint32_t pixel, std::uint32_t replicate);

/// Point `index` of the block: four numbers in [0, 1), multiples of 2^-24, jointly stratified over the
/// indices of the block. These are Sobol' points (Joe and Kuo 2008, first four dimensions), Owen-scrambled
/// and shuffled by the Laine-Karras hash (Laine and Karras 2011, constants of Vegdahl 2021), after the
/// tabulated form of Burley 2020, "Practical Hash-based Owen Scrambling".
std::array<float, 4> draw(SampleBlock block,
                          std::uint32_t index,
                          std::uint32_t bounce,
                          SampleDimension dimension);

/// The same for eight paths, by the seeds of their blocks and their indices.
std::array<Float8, 4> draw(const Word8& block_seeds,
                           const Word8& indices,
                           std::uint32_t bounce,
                           SampleDimension dimension);

}  // namespace orbs::tracer
