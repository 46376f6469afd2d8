#include "metrics/block_sums.h"

#include <algorithm>
#include <cstddef>

namespace orbs::metrics {

namespace {

void add_variances(const PairSamples& samples, std::size_t pixel, Block& block) {
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t i = 3 * pixel + c;
    const double of_reference = variance_at(samples.reference_variance, i);
    auto& sums = block.channels.at(c);
    if (samples.noise_source != NoiseSource::Scatter)
      sums.own.add(variance_at(samples.result_variance, i) + of_reference);
    sums.expected.add((samples.variance_ratio.at(c) + 1) * of_reference);
  }
}

// The pairs do not overlap. The sum is scaled up for pixels without a partner.
void add_scatter(const PairSamples& samples, Block& block) {
  int pairs = 0;
  for_each_pair(samples, block.where, [&](std::size_t a, std::size_t b) {
    ++pairs;
    for (std::size_t c = 0; c < 3; ++c) {
      const double step = samples.difference(3 * a + c) - samples.difference(3 * b + c);
      block.channels.at(c).own.add(step * step);
    }
  });
  if (4 * pairs < block.pixels) {  // too few to speak for the rest
    block.pixels = 0;
    return;
  }
  const double scale = block.pixels / (2.0 * pairs);
  for (auto& sums : block.channels) sums.own = {sums.own.sum * scale, sums.own.squares * scale * scale};
}

Block sum_block(const PairSamples& samples, const Rectangle& where) {
  Block block{where, 0, {}};
  for_each_block_pixel(samples, where, [&](std::size_t pixel) {
    ++block.pixels;
    add_variances(samples, pixel, block);
    for (std::size_t c = 0; c < 3; ++c) {
      block.channels.at(c).difference += samples.difference(3 * pixel + c);
      block.channels.at(c).reference += static_cast<double>(samples.reference[3 * pixel + c]);
    }
  });
  if (samples.noise_source == NoiseSource::Scatter) add_scatter(samples, block);
  return block;
}

void add(PooledVariance& to, const PooledVariance& from) {
  to.sum += from.sum;
  to.squares += from.squares;
}

void merge_into(Block& to, const Block& from) {
  to.where.x1 = std::max(to.where.x1, from.where.x1);
  to.where.y1 = std::max(to.where.y1, from.where.y1);
  if (from.pixels == 0) return;
  to.pixels += from.pixels;
  for (std::size_t c = 0; c < 3; ++c) {
    auto& sums = to.channels.at(c);
    sums.difference += from.channels.at(c).difference;
    sums.reference += from.channels.at(c).reference;
    add(sums.own, from.channels.at(c).own);
    add(sums.expected, from.channels.at(c).expected);
  }
}

std::size_t block_index(const BlockGrid& grid, int column, int row) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns) +
         static_cast<std::size_t>(column);
}

}  // namespace

BlockGrid sum_blocks(const PairSamples& samples) {
  BlockGrid grid{
      (samples.width + kBlock_px - 1) / kBlock_px, (samples.height + kBlock_px - 1) / kBlock_px, {}};
  for (const Rectangle& where : blocks_of(samples)) grid.blocks.push_back(sum_block(samples, where));
  return grid;
}

BlockGrid merge_blocks(const BlockGrid& grid) {
  BlockGrid merged{(grid.columns + 1) / 2, (grid.rows + 1) / 2, {}};
  merged.blocks.resize(static_cast<std::size_t>(merged.columns) * static_cast<std::size_t>(merged.rows));
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const auto& from = grid.blocks[block_index(grid, column, row)];
      auto& to = merged.blocks[block_index(merged, column / 2, row / 2)];
      if (row % 2 == 0 && column % 2 == 0) to.where = from.where;
      merge_into(to, from);
    }
  return merged;
}

}  // namespace orbs::metrics
