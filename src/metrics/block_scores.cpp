#include "metrics/block_scores.h"

#include "base/student_t.h"

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

Score score_of_block(const PairSamples& samples, const Rectangle& block, std::size_t channel) {
  DifferenceVariance variance(samples, channel, 1);
  double difference = 0;
  double reference = 0;
  for_each_block_pixel(samples, block, [&](std::size_t pixel) {
    const std::size_t i = 3 * pixel + channel;
    variance.add(pixel);
    difference += samples.difference(i);
    reference += static_cast<double>(samples.reference[i]);
  });
  const PooledVariance& pooled = variance.pooled();
  return {score(difference, reference, pooled.sum), pooled.degrees()};
}

int counted_pixels(const PairSamples& samples, const Rectangle& block) {
  int count = 0;
  for_each_block_pixel(samples, block, [&](std::size_t) { ++count; });
  return count;
}

// Y. Benjamini, Y. Hochberg, "Controlling the False Discovery Rate", J. R. Stat. Soc. B 57(1), 1995: the
// largest k with p_(k) <= rate k / tests. Where nothing is wrong, any finding at all has the chance `rate`.
int count_findings(std::vector<double> probabilities, int tests, double rate) {
  std::sort(probabilities.begin(), probabilities.end());
  for (auto k = static_cast<int>(probabilities.size()); k > 0; --k)
    if (probabilities[static_cast<std::size_t>(k - 1)] <= rate * k / tests) return k;
  return 0;
}

}  // namespace

BlockScores score_blocks(const PairSamples& samples, double false_alarms) {
  constexpr int kFewestPixels = kBlock_px * kBlock_px / 4;
  constexpr double kWorthATest =
      3;  // below, no t has a probability under 0.0027, and no finding is above the rate
  BlockScores scores;
  std::vector<double> probabilities;
  for (const Rectangle& block : blocks_of(samples)) {
    if (counted_pixels(samples, block) < kFewestPixels) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const Score one = score_of_block(samples, block, c);
      ++scores.tested;
      if (one.z > kWorthATest) probabilities.push_back(student_tail(one.z, one.degrees));
      if (one.z <= scores.largest) continue;
      scores.largest = one.z;
      scores.where = block;
    }
  }
  scores.off = count_findings(std::move(probabilities), scores.tested, false_alarms);
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
