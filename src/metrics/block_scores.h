#pragma once

#include "metrics/noise_test.h"
#include "metrics/pair_samples.h"

namespace orbs::metrics {

/// Blocks whose means differ by more than noise, with the chance `false_alarms` that a right image has one.
/// `samples` must have the result's variance.
BlockScores score_blocks(const PairSamples& samples, double false_alarms);

PixelScores score_pixels(const PairSamples& samples);

}  // namespace orbs::metrics
