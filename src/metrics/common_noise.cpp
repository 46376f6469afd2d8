#include "metrics/common_noise.h"

#include "base/statistics.h"

#include <algorithm>
#include <cmath>

namespace orbs::metrics {

RendersApart renders_apart(const image::Image& first, const image::Image& second, int spp_of_both) {
  RendersApart apart{spp_of_both};
  const auto a = image::select_rgb(first, "").pixels;
  const auto b = image::select_rgb(second, "").pixels;
  for (std::size_t i = 0; i < a.size(); ++i)
    apart.means.at(i % 3) += static_cast<double>(a[i]) - static_cast<double>(b[i]);
  for (double& mean : apart.means) mean /= static_cast<double>(first.pixel_count());
  return apart;
}

CommonNoise common_noise_of(const std::vector<RendersApart>& looks) {
  CommonNoise noise;
  double samples = 0;
  for (const auto& look : looks) {
    samples += look.spp;
    for (std::size_t c = 0; c < noise.error.size(); ++c)
      noise.error.at(c) += look.means.at(c) * look.means.at(c) * look.spp / 4;
  }
  noise.degrees = static_cast<double>(looks.size());
  for (double& error : noise.error) error = samples > 0 ? std::sqrt(error / (noise.degrees * samples)) : 0;
  return noise;
}

namespace {

// What all pixels have in common is told by the looks; here it would count twice.
std::vector<double> difference_of(const PairSamples& samples, const std::array<image::Image, 2>& halves) {
  const auto first = image::select_rgb(halves[0], "").pixels;
  const auto second = image::select_rgb(halves[1], "").pixels;
  std::vector<double> difference(first.size());
  std::array<double, 3> apart{};
  std::array<double, 3> light{};
  for (std::size_t i = 0; i < first.size(); ++i) {
    difference[i] = static_cast<double>(first[i]) - static_cast<double>(second[i]);
    if (samples.included[i / 3] == 0) continue;
    apart.at(i % 3) += difference[i];
    light.at(i % 3) += static_cast<double>(samples.result[i]);
  }
  for (std::size_t i = 0; i < first.size(); ++i)
    if (light.at(i % 3) > 0)
      difference[i] -= apart.at(i % 3) / light.at(i % 3) * static_cast<double>(samples.result[i]);
  return difference;
}

// Over whole blocks of this side: the squares of their sums over their variances, all blocks together, as the
// mean of ratios would be made of blocks that hold rounding alone. The halves have half of the samples each,
// so their difference has four times the variance of the mean.
double inflation_of(const PairSamples& samples,
                    const std::vector<double>& difference,
                    std::size_t channel,
                    int side_px) {
  constexpr double kStandardErrors = 2;
  double squares = 0;
  PooledVariance variance;
  for (int y = 0; y + side_px <= samples.height; y += side_px)
    for (int x = 0; x + side_px <= samples.width; x += side_px) {
      double apart = 0;
      double of_block = 0;
      for_each_block_pixel(samples, {x, y, x + side_px, y + side_px}, [&](std::size_t pixel) {
        apart += difference[3 * pixel + channel];
        of_block += 4 * variance_at(samples.result_variance, 3 * pixel + channel);
      });
      squares += apart * apart;
      variance.add(of_block);
    }
  if (!(variance.sum > 0)) return 1;
  // The square of a standard normal number has the variance 2; so many blocks carry the variance.
  const double inflation = squares / variance.sum;
  return inflation > 1 + kStandardErrors * std::sqrt(2 / variance.degrees()) ? inflation : 1;
}

}  // namespace

AreaNoise area_noise(const PairSamples& samples, const std::array<image::Image, 2>& halves) {
  AreaNoise noise;
  if (samples.result_variance.empty()) return noise;
  const auto difference = difference_of(samples, halves);
  for (std::size_t c = 0; c < 3; ++c) {
    noise.over_8px.at(c) = inflation_of(samples, difference, c, kBlock_px);
    noise.over_16px.at(c) =
        std::max(noise.over_8px.at(c), inflation_of(samples, difference, c, 2 * kBlock_px));
  }
  return noise;
}

double common_reach(const PairSamples& samples, std::size_t channel) {
  const auto& noise = samples.common_noise;
  if (!(noise.degrees > 0)) return 0;
  return student_quantile(kOutsideCommon, noise.degrees) * noise.error.at(channel);
}

double common_share(const PairSamples& samples, std::size_t channel) {
  double light = 0;
  for (std::size_t pixel = 0; pixel < samples.included.size(); ++pixel)
    if (samples.included[pixel] != 0) light += static_cast<double>(samples.reference[3 * pixel + channel]);
  return light > 0 ? common_reach(samples, channel) * static_cast<double>(samples.included_count) / light : 0;
}

}  // namespace orbs::metrics
