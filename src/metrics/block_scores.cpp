#include "metrics/block_scores.h"

#include "base/student_t.h"
#include "metrics/block_sums.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace orbs::metrics {

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
    if (probabilities[static_cast<std::size_t>(k - 1)] <= rate * k / tests) return k;
  return 0;
}

// What stands out from the noise in one channel of one block.
struct Finding {
  Score score;
  double relative_deviation = 0;  // standard deviation over the reference's mean
};

Finding test_channel(const BlockSums& sums) {
  const PooledVariance& variance = sums.variance();
  return {{score(sums.difference, sums.reference, variance.sum), variance.degrees()},
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

BlockScale score_scale(const BlockGrid& grid, std::size_t scale, double rate, BlockScores& scores) {
  constexpr double kWorthATest =
      3;  // below, no t has a probability under 0.0027, and no finding is above the rate
  BlockScale result{kTestedBlocks_px.at(scale), 0, 0, {}};
  const int fewest_pixels = result.side_px * result.side_px / 4;
  std::vector<Finding> findings;
  std::vector<double> probabilities;
  for (const Block& block : grid.blocks) {
    if (block.pixels < fewest_pixels) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      findings.push_back(test_channel(block.channels.at(c)));
      const Score& one = findings.back().score;
      if (one.z > kWorthATest) probabilities.push_back(student_tail(one.z, one.degrees));
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
    scores.scales.at(scale) =
        score_scale(grid, scale, false_alarms / static_cast<double>(kTestedBlocks_px.size()), scores);
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
