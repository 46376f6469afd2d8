#include "metrics/rare_light.h"

#include <cmath>

namespace orbs::metrics {

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
