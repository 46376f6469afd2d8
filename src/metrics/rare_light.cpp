#include "metrics/rare_light.h"

#include <cmath>

namespace orbs::metrics {

std::array<double, 3> hit_size(const std::vector<float>& variances,
                               const std::vector<std::uint8_t>& included) {
  std::array<double, 3> hits{};
  std::array<double, 3> sums{};
  for (std::size_t i = 0; i < variances.size(); ++i) {
    if (!included.empty() && included[i / 3] == 0) continue;
    const double variance = variance_at(variances, i);
    hits.at(i % 3) += variance * std::sqrt(variance);
    sums.at(i % 3) += variance;
  }
  for (std::size_t c = 0; c < hits.size(); ++c) hits.at(c) = sums.at(c) > 0 ? hits.at(c) / sums.at(c) : 0;
  return hits;
}

double unseen_light(double hit, const PooledVariance& noise, double probability) {
  constexpr double kKnowsItsNoise = 10;  // pixels
  return noise.degrees() < kKnowsItsNoise ? -hit * std::log(probability) : 0;
}

double unseen_light(const PairSamples& samples,
                    const Rectangle& region,
                    std::size_t channel,
                    double probability) {
  const double hit = samples.hit_size.at(channel);
  if (!(hit > 0)) return 0;
  PooledVariance noise;
  for_each_block_pixel(samples, region, [&](std::size_t pixel) {
    noise.add(variance_at(samples.result_variance, 3 * pixel + channel));
  });
  return unseen_light(hit, noise, probability);
}

}  // namespace orbs::metrics
