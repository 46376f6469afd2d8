#include "judge/psnr_bias.h"

#include "metrics/image_pair.h"

#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace orbs {
namespace {

constexpr float kValue = 0.2F;
constexpr int kSamples = 8;

// A right image of exponential samples, grey: all channels have the same noise.
image::Image noisy(int side, std::mt19937_64& random) {
  auto image = image::make_image(side, side, {"R", "G", "B"});
  std::gamma_distribution<float> mean(kSamples, kValue / kSamples);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const float value = mean(random);
      for (std::size_t c = 0; c < 3; ++c) image.at(x, y, c) = value;
    }
  return image;
}

image::Image middle(const std::array<image::Image, 2>& halves) {
  auto image = halves[0];
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = (halves[0].pixels[i] + halves[1].pixels[i]) / 2;
  return image;
}

judge::PsnrBias bias_of(int side, std::mt19937_64& random) {
  const std::array<image::Image, 2> halves{noisy(side, random), noisy(side, random)};
  auto reference = image::make_image(side, side, {"R", "G", "B"});
  for (auto& value : reference.pixels) value = kValue;
  return *judge::psnr_bias(metrics::make_image_pair(middle(halves), reference, {}, {.halves = &halves}));
}

}  // namespace

// At an eighth of their size the smallest scenes have one block of 8 x 8 px, whose scatter about its own mean
// is none: 64 pixels were sure of an error that they did not have.
TEST(PsnrBias, IsNoSurerThanTheFewPixelsOfASmallImage) {
  constexpr int kImages = 400;
  constexpr double kReach = 5;
  for (const int side : {4, 8, 12, 16}) {
    std::mt19937_64 random{7};
    for (int i = 0; i < kImages; ++i) {
      const auto bias = bias_of(side, random);
      EXPECT_LT(bias.squared - 0.07 * bias.noise, kReach * bias.standard_error) << side << " px, image " << i;
      EXPECT_LE(bias.degrees, side * side - 1);
    }
  }
}

TEST(PsnrBias, OfASinglePixelIsSureOfNothing) {
  std::mt19937_64 random{7};
  EXPECT_TRUE(std::isinf(bias_of(1, random).standard_error));
}

}  // namespace orbs
