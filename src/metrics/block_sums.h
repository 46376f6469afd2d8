#pragma once

#include "metrics/pair_samples.h"

#include <array>
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

}  // namespace orbs::metrics
