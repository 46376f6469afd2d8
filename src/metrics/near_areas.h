#pragma once

#include "metrics/pair_samples.h"

#include <optional>

namespace orbs::metrics {

/// Areas whose means are nearer to the reference than independent noise of their pixels lets them be.
struct NearAreas {
  int side_px = 0;
  int count = 0;
  double share = 0;  // mean of squared sum of the differences over what their noise makes of it
};

/// An image that was corrected by the reference, as its own pixels times blur(reference) / blur(own), has
/// noise from pixel to pixel and none in its means. The same is true of samples that depend on each other
/// from pixel to pixel (blue noise over the image) and of some filters of noise, so this accuses nobody.
///
/// Of blocks of 8, 16 and 32 px, from 16 of them on, the square of the sum of the differences over the
/// smaller of two expectations of it: the sum of their squares, whatever the image says of its noise, and
/// that of the variances, which the difference of two filters at edges does not enter. Both are right or too
/// small where pixels are independent, so the mean over n blocks is 1 or more. Below a third by the bound
/// of Chernoff for a chi^2 of n degrees of freedom, exp(n / 2 (1 - t + log t)), counts. Channels share their
/// noise and are no more degrees.
///
/// Nothing where the result's noise is not known.
std::optional<NearAreas> near_areas(const PairSamples& samples, double false_alarms);

}  // namespace orbs::metrics
