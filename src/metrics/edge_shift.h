#pragma once

#include "base/statistics.h"
#include "metrics/pair_samples.h"

#include <array>

namespace orbs::metrics {

/// How far the result is shifted against the reference, in px to the left and up, as its edges and textures
/// tell.
struct EdgeShift {
  /// The shift along x and y; `low` and `high` are the ends of what noise and misfit leave. {0, 0, 0}
  /// where no shift is told: no detail, no known noise, or a difference that no shift makes.
  std::array<Interval, 2> px{};
  std::array<double, 2> z{};  // over their standard errors
};

/// A shift by s is told by T - R = s M, with R and T the two images less their means over 5 x 5 px, so that
/// what changes slowly over the image, as light that is off somewhere, counts neither for nor against
/// it; and with M the slope of their mean, which describes a shift of sharp edges to the second order. The
/// normal equations take the slope of R for one M: the noise of T is not squared in them, and adds nothing.
/// Each pixel counts by its share of the brightest light within three pixels, so that a lamp does not decide
/// alone, nor is the dark left out. The slope over two pixels is less than that of a sharp edge, whose shift
/// comes out larger by up to a half.
///
/// It is told where it explains a third at least of the squared difference beyond noise: half of it or more
/// where the image is shifted, nothing where a symmetric filter or other light makes the difference. Its
/// reach is that of the noise, by Student's distribution, and three standard errors by what it leaves of
/// blocks of 4 x 4 px, whichever is larger; a block is as long as neighbours at an edge differ alike.
EdgeShift edge_shift(const PairSamples& samples, double false_alarms);

}  // namespace orbs::metrics
