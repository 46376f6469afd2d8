#include "studies/seed_noise.h"

#include "metrics/compare.h"
#include "metrics/psnr.h"

#include <cmath>

namespace orbs::studies {

namespace {

double relative_mse(const std::vector<image::Image>& images, const image::Image& mean) {
  constexpr double kFloor = 0.01;  // keeps black pixels from outweighing all others
  const auto count = static_cast<double>(images.size());
  double total = 0;
  for (std::size_t i = 0; i < mean.pixels.size(); ++i) {
    double own_mean = 0;
    for (const auto& image : images) own_mean += static_cast<double>(image.pixels[i]) / count;
    double squares = 0;
    for (const auto& image : images) {
      const double difference = static_cast<double>(image.pixels[i]) - own_mean;
      squares += difference * difference;
    }
    const double level = static_cast<double>(mean.pixels[i]);
    total += squares / (count - 1) / (level * level + kFloor);
  }
  return total / static_cast<double>(mean.pixels.size());
}

}  // namespace

SeedNoise noise_of_seeds(const std::vector<image::Image>& images, const image::Image& mean, int threads) {
  SeedNoise noise;
  noise.relative_mse = relative_mse(image::colours_of(images), mean);
  double mse = 0;
  for (std::size_t i = 1; i < images.size(); ++i) {
    const auto comparison = metrics::compare(images[i - 1], images[i], {},
                                             {.negatives = metrics::NegativePixels::Allowed,
                                              .threads = threads,
                                              .no_others = true,
                                              .also = {"psnr_srgb8"}});
    const double psnr = metrics::value_of(comparison, "psnr_srgb8").value();
    mse += std::pow(10, -psnr / 10) * 255 * 255;
  }
  noise.psnr_srgb8_db = metrics::psnr_db(255, mse / static_cast<double>(images.size() - 1) / 2);
  return noise;
}

}  // namespace orbs::studies
