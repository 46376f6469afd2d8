#pragma once

#include "image/image.h"
#include "registry/gates.h"

#include <limits>
#include <string>
#include <vector>

namespace orbs::references {

/// How far the noise of a reference must lie below the psnr_srgb8 gates of its cases.
constexpr double kReferenceMargin_db = 10;

/// The noise of a reference, or the most that it may be.
struct ReferenceNoise {
  double psnr_db = 0;  // that the noise alone lets expect
  double mean = 0;     // relative standard error of the mean of a channel, of the worst one
  double tile = 0;  // of a tile of 16 x 16 px, relative to the means of tile and image together, of the worst
};

constexpr ReferenceNoise kAnyNoise{0, std::numeric_limits<double>::infinity(),
                                   std::numeric_limits<double>::infinity()};

/// From the variances of the image, which has them. A channel whose mean is not ten standard errors above 0
/// has no gate either (metrics/noise_test.h) and is left out.
ReferenceNoise noise_of(const image::Image& image);

/// The most that gates leave room for; any, where there is no such gate.
///
/// The noise of a reference stays, however many samples a renderer takes. Its variance may be half of what a
/// pass leaves room for: then it costs a right renderer twice the samples at most, and leaves none undecided.
/// The interval of a mean must fit into its limit as it is; those of the tiles must all fit with whatever
/// noise they have, the largest of a few hundred of which is 3.6 standard errors.
ReferenceNoise most_noise(const std::vector<registry::Gate>& gates);

/// The smaller of both.
ReferenceNoise stricter(const ReferenceNoise& a, const ReferenceNoise& b);

/// By how much the variance must fall; at most 1 where the noise is small enough. As many times the samples.
double times_too_noisy(const ReferenceNoise& noise, const ReferenceNoise& most);

/// "45.20 dB, 0.11 % of the mean, 0.8 % of a tile"; without what may be any.
std::string noise_text(const ReferenceNoise& noise);

}  // namespace orbs::references
