#pragma once

#include <cstdint>

namespace orbs::tracer {

/// The use of a set of four random numbers. The numbers are a function of (seed, pixel, block, sample,
/// bounce, dimension), so that switching one use on or off does not shift the others. Sets are numbered 4
/// bounce + dimension: a set drawn at bounce 0 alone needs a dimension that no other has at bounce 0, and a
/// set drawn at every bounce needs one that is unique modulo 4.
enum class SampleDimension : std::uint32_t {
  PixelAndFirstLight,  // at bounce 0 alone
  LightPick,           // at bounce 0 alone
  Light,
  Scatter,
  MirroredLight,
  Wavelength,  // at bounce 0 alone
  Time = 9,    // at bounce 0 alone; 6 to 8 are sets of bounce 1
  Lens = 13,   // at bounce 0 alone, of cameras that have one; 10 to 12 are sets of bounce 2
  // The four of each bounce are taken; these lie beyond those of 2^29 bounces.
  Reradiation = 1U << 31,
  Blend = (1U << 31) + 1
};

}  // namespace orbs::tracer
