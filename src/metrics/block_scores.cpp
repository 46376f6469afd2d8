#include "metrics/block_scores.h"

#include "base/nth.h"
#include "base/statistics.h"
#include "metrics/common_noise.h"
#include "metrics/rare_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

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

namespace {

struct Score {
  double z = 0;  // not negative
  double degrees = 1;
};

// |z| of a difference with this variance; what is negligible beside the reference is none.
double score(double difference, double reference, double variance) {
  if (std::fabs(difference) <= kNegligible * std::fabs(reference)) return 0;
  return std::fabs(difference) / std::sqrt(variance);  // infinite without noise
}

// Y. Benjamini, Y. Hochberg, "Controlling the False Discovery Rate", J. R. Stat. Soc. B 57(1), 1995: the
// largest k with p_(k) <= rate k / tests. Where nothing is wrong, any finding at all has the chance `rate`.
int count_findings(std::vector<double> probabilities, int tests, double rate) {
  std::sort(probabilities.begin(), probabilities.end());
  for (auto k = static_cast<int>(probabilities.size()); k > 0; --k)
    if (nth(probabilities, k - 1) <= rate * k / tests) return k;
  return 0;
}

// What stands out from the noise in one channel of one block.
struct Finding {
  Score score;
  double relative_deviation = 0;  // standard deviation over the reference's mean
};

// What pixels have in common (common_noise.h): by how much the sum over a block is noisier than they say, and
// how far the mean of the image may be off.
struct InCommon {
  std::array<double, 3> inflation{};
  std::array<double, 3> share{};
};

InCommon in_common_of(const PairSamples& samples, int side_px) {
  InCommon in_common{side_px == kBlock_px ? samples.area_noise.over_8px : samples.area_noise.over_16px, {}};
  for (std::size_t c = 0; c < 3; ++c) in_common.share.at(c) = common_share(samples, c);
  return in_common;
}

Finding test_channel(const BlockSums& sums, double inflation, double share) {
  PooledVariance variance = sums.variance();
  variance.scale(inflation);
  const double of_block = std::max(0.0, std::fabs(sums.difference) - share * std::fabs(sums.reference));
  return {{score(of_block, sums.reference, variance.sum), variance.degrees()},
          std::sqrt(variance.sum) / std::fabs(sums.reference)};
}

double quantile(std::vector<double> values, double share) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// A single block is found where its probability is below rate / tests. The typical degrees of freedom stand
// for all, as a quantile of Student's distribution for each block would cost more than the test.
std::optional<double> smallest_error(const std::vector<Finding>& findings, double rate) {
  constexpr double kMostBlocks = 0.9;
  if (findings.empty()) return std::nullopt;
  std::vector<double> deviations;
  std::vector<double> degrees;
  for (const auto& finding : findings) {
    deviations.push_back(finding.relative_deviation);
    degrees.push_back(finding.score.degrees);
  }
  const double critical =
      student_quantile(rate / static_cast<double>(findings.size()), quantile(std::move(degrees), 0.5));
  return std::max(kNegligible, critical * quantile(std::move(deviations), kMostBlocks));
}

void note_largest(const Block& block, std::size_t channel, double z, std::size_t scale, BlockScores& scores) {
  if (z <= scores.largest) return;
  const BlockSums& sums = block.channels.at(channel);
  scores.largest = z;
  scores.largest_error = sums.difference / sums.reference;
  scores.where = block.where;
  scores.largest_at = scale;
}

// Of a right image to be farther off. A block that is too dark may lack light that no sample has found.
double probability_of(const PairSamples& samples,
                      const Block& block,
                      std::size_t channel,
                      const Score& score) {
  const double by_noise = student_tail(score.z, score.degrees);
  const double difference = block.channels.at(channel).difference;
  if (difference >= 0) return by_noise;
  const double unseen = unseen_light(samples, block.where, channel, std::exp(-1));  // one hit
  return unseen > 0 ? std::max(by_noise, std::exp(difference / unseen)) : by_noise;
}

BlockScale score_scale(
    const PairSamples& samples, const BlockGrid& grid, std::size_t scale, double rate, BlockScores& scores) {
  constexpr double kWorthATest =
      3;  // below, no t has a probability under 0.0027, and no finding is above the rate
  BlockScale result{kTestedBlocks_px.at(scale), 0, 0, {}};
  const auto in_common = in_common_of(samples, result.side_px);
  const int fewest_pixels = result.side_px * result.side_px / 4;
  std::vector<Finding> findings;
  std::vector<double> probabilities;
  for (const Block& block : grid.blocks) {
    if (block.pixels < fewest_pixels) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      findings.push_back(
          test_channel(block.channels.at(c), in_common.inflation.at(c), in_common.share.at(c)));
      const Score& one = findings.back().score;
      if (one.z > kWorthATest) probabilities.push_back(probability_of(samples, block, c, one));
      note_largest(block, c, one.z, scale, scores);
    }
  }
  result.tested = static_cast<int>(findings.size());
  result.off = count_findings(std::move(probabilities), result.tested, rate);
  result.smallest_error = smallest_error(findings, rate);
  return result;
}

}  // namespace

BlockScores score_blocks(const PairSamples& samples, double false_alarms) {
  BlockScores scores;
  BlockGrid grid = sum_blocks(samples);
  for (std::size_t scale = 0; scale < kTestedBlocks_px.size(); ++scale) {
    if (scale > 0) grid = merge_blocks(grid);
    scores.scales.at(scale) = score_scale(
        samples, grid, scale, false_alarms / static_cast<double>(kTestedBlocks_px.size()), scores);
    scores.tested += scores.scales.at(scale).tested;
    scores.off += scores.scales.at(scale).off;
  }
  return scores;
}

PixelScores score_pixels(const PairSamples& samples) {
  constexpr double kBeyond = 3;
  PixelScores scores;
  std::size_t counted = 0;
  std::size_t beyond = 0;
  for (const Rectangle& block : blocks_of(samples)) {
    std::array<double, 3> mean{};
    int pixels = 0;
    for_each_block_pixel(samples, block, [&](std::size_t pixel) {
      for (std::size_t c = 0; c < 3; ++c) mean.at(c) += variance_at(samples.result_variance, 3 * pixel + c);
      ++pixels;
    });
    for_each_block_pixel(samples, block, [&](std::size_t pixel) {
      for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t i = 3 * pixel + c;
        // An estimate from few samples that is small by accident counts as that of its block.
        const double variance = std::max(variance_at(samples.result_variance, i), mean.at(c) / pixels) +
                                variance_at(samples.reference_variance, i);
        const double z = score(samples.difference(i), static_cast<double>(samples.reference[i]), variance);
        ++counted;
        if (z > kBeyond) ++beyond;
        if (z <= scores.largest) continue;
        scores.largest = z;
        const auto x = static_cast<int>(pixel % static_cast<std::size_t>(samples.width));
        const auto y = static_cast<int>(pixel / static_cast<std::size_t>(samples.width));
        scores.where = {x, y, x + 1, y + 1};
      }
    });
  }
  scores.share_beyond_3 = static_cast<double>(beyond) / static_cast<double>(counted);
  return scores;
}

}  // namespace orbs::metrics
