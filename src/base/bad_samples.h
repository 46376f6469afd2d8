#pragma once

namespace orbs {

/// The largest share of an image's samples that may be missing because they came out as no finite number, in
/// millionths, and the largest number of rays over that of samples that may have met something else than the
/// scene because a shape did not answer. Where all of them lie in one tile of 16 x 16 px of an image of
/// 512 x 512 px, a 1024th of it, the tile lacks a tenth of its samples, and a tenth of its light is what the
/// gate local_bias allows.
inline constexpr double kMostBadSamples_ppm = 100;

}  // namespace orbs
