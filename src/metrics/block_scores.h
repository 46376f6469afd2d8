#pragma once

#include "metrics/pair_samples.h"

namespace orbs::metrics {

/// A relative difference of means that is never called an error: rounding in float over thousands of samples
/// and the eighth bit of a texture make one of this order in renderers that are both right.
constexpr double kNegligible = 1e-3;

/// Means of result and reference over blocks of 8 x 8 px, each channel one test.
struct BlockScores {
  int tested = 0;      // blocks with at least 16 counted pixels, times channels
  int off = 0;         // differ by more than noise: Benjamini and Hochberg 1995
  double largest = 0;  // |z|; infinite for a difference where there is no noise
  Rectangle where;     // the block that has it
};

/// Single pixels, each channel one. Few samples are far from normally distributed, so these point at places
/// and decide nothing.
struct PixelScores {
  double largest = 0;  // |z|
  Rectangle where;
  double share_beyond_3 = 0;  // 0.0027 is expected of normally distributed noise
};

/// Blocks whose means differ by more than noise. `false_alarms` is the probability that a right image has
/// one. `samples` must have the result's variance.
BlockScores score_blocks(const PairSamples& samples, double false_alarms);

/// `samples` must have the result's variance.
PixelScores score_pixels(const PairSamples& samples);

}  // namespace orbs::metrics
