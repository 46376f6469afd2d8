#pragma once

#include "base/statistics.h"
#include "metrics/pair_samples.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace orbs::metrics {

/// The share of the reference's own noise that the result holds: 0 where both were rendered independently, 1
/// in a copy, also in one that other noise was added to, a half in the mean of the reference and an image.
/// Nothing where the reference states no noise, or fewer than 16 blocks show it. `smooth`: smooth_pixels.
///
/// Let r be the noise of the reference, s the right image and n the noise of the result, each minus the mean
/// of its four neighbours, which leaves little of s. Then E[(s + r) ((s + n) - (s + r))] is -E[r^2] where n
/// and r are independent, and -(1 - a) E[r^2] where n holds a r, so it tells a. E[r^2] follows from the
/// stated variances of the reference, scaled to its pixels where those show less on average: references round
/// their variances. Blocks whose pixels hold much more have detail, and an error in proportion to s would
/// look like shared noise there; they are left out.
std::optional<Interval> shared_noise(const PairSamples& samples,
                                     const std::vector<std::uint8_t>& smooth,
                                     double false_alarms);

}  // namespace orbs::metrics
