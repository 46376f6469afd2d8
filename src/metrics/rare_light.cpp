#include "metrics/rare_light.h"

#include <algorithm>
#include <cmath>

namespace orbs::metrics {

double unseen_light(double hit, const PooledVariance& noise, double probability) {
  constexpr double kKnowsItsNoise = 10;  // pixels
  return noise.degrees() < kKnowsItsNoise ? -hit * std::log(probability) : 0;
}

double unseen_share(const PairSamples& samples, int spp) {
  constexpr double kOdds = 1e5;
  constexpr double kMostShare = 0.1;
  const bool is_computed = std::all_of(samples.reference_variance.begin(), samples.reference_variance.end(),
                                       [](float variance) { return variance == 0; });
  if (spp == 0 || !is_computed || samples.noise_source == NoiseSource::Reference) return 0;
  const double all = static_cast<double>(samples.included_count) * spp;
  return all < -kOdds * std::log(kWrongFails) ? kMostShare : 0;
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
