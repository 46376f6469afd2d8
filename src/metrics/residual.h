#pragma once

#include "metrics/pair_samples.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace orbs::metrics {

/// 1 where a pixel counts, and the reference changes by less than a tenth over the 3 x 3 px around it, beyond
/// its own noise. Correct renderers differ at edges, where each has its own antialiasing, and nowhere else.
std::vector<std::uint8_t> smooth_pixels(const PairSamples& samples);

/// Fewer smooth pixels speak for no image.
constexpr std::ptrdiff_t kFewestSmoothPixels = 1000;

/// How alike the differences of pixels that lie (dx, dy) apart are. Noise of a box filter of one pixel is not
/// alike at all.
struct Correlation {
  int dx = 0;
  int dy = 0;
  double value = 0;  // of -1 to 1
  double low = 0;    // ends of its interval
  double high = 0;
};

/// The strongest correlation between the differences of smooth pixels that lie 1 or 2 px apart, of those
/// whose whole interval lies beyond a twentieth: a filter wider than a pixel, a denoiser, or an error with
/// structure. Nothing when there is none, when the differences are no larger than what floats round, or of
/// fewer than 1000 smooth pixels. `false_alarms` is the probability that a right image has one.
std::optional<Correlation> strongest_correlation(const PairSamples& samples,
                                                 const std::vector<std::uint8_t>& smooth,
                                                 double false_alarms);

}  // namespace orbs::metrics
