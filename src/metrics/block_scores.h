#pragma once

#include "metrics/pair_samples.h"

#include <array>
#include <optional>
#include <vector>

namespace orbs::metrics {

/// Sums over the counted pixels of one block and channel.
struct BlockSums {
  double difference = 0;  // result - reference
  double reference = 0;
  PooledVariance own;       // of `difference`, as the image itself tells it
  PooledVariance expected;  // the same by the reference's variance and PairSamples::variance_ratio

  /// The larger of the two; DifferenceVariance says why.
  const PooledVariance& variance() const { return own.sum >= expected.sum ? own : expected; }
};

struct Block {
  Rectangle where;
  int pixels = 0;  // that count
  std::array<BlockSums, 3> channels;
};

/// Blocks of one size that cover the image by rows; those at the right and lower edge may be smaller.
struct BlockGrid {
  int columns = 0;
  int rows = 0;
  std::vector<Block> blocks;
};

/// Blocks of kBlock_px. Where the noise is known from scatter alone, `own` is that of horizontal neighbours:
/// (a
/// - b)^2 has the expectation var(a) + var(b) where both have the same bias. Structure in the error counts as
/// noise there, so a test by it is only too careful.
BlockGrid sum_blocks(const PairSamples& samples);

/// Two by two blocks become one.
BlockGrid merge_blocks(const BlockGrid& grid);

/// A relative difference of means that is never called an error: rounding in float over thousands of samples
/// and the eighth bit of a texture make one of this order in renderers that are both right.
constexpr double kNegligible = 1e-3;

/// Sides of the blocks whose means are tested. A small error over a large area and a large one over a small
/// area are lost in the noise at any one size.
constexpr std::array kTestedBlocks_px{8, 16, 32, 64};

/// Means of result and reference over the blocks of one size, each channel one test.
struct BlockScale {
  int side_px = 0;
  int tested = 0;  // blocks of which a quarter of the pixels count, times channels
  int off = 0;     // differ by more than noise: Benjamini and Hochberg 1995
  /// The relative error of a block's mean that would be found in nine of ten blocks; noise hides what is
  /// smaller. Nothing where no block was tested.
  std::optional<double> smallest_error;
};

/// The blocks of all sizes.
struct BlockScores {
  std::array<BlockScale, kTestedBlocks_px.size()> scales;
  int tested = 0;  // of all sizes
  int off = 0;
  double largest = 0;          // |z|; infinite for a difference where there is no noise
  double largest_error = 0;    // mean(result) / mean(reference) - 1 of that block and channel
  Rectangle where;             // the block that has it
  std::size_t largest_at = 0;  // its index in `scales`
};

/// Single pixels, each channel one. Few samples are far from normally distributed, so these point at places
/// and decide nothing.
struct PixelScores {
  double largest = 0;  // |z|
  Rectangle where;
  double share_beyond_3 = 0;  // 0.0027 is expected of normally distributed noise
};

/// Blocks whose means differ by more than noise, for every noise source. `false_alarms` is the probability
/// that a right image has one.
BlockScores score_blocks(const PairSamples& samples, double false_alarms);

/// `samples` must have the result's variance.
PixelScores score_pixels(const PairSamples& samples);

}  // namespace orbs::metrics
