#include "references/noise_limits.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

using namespace orbs;
using references::kAnyNoise;
using references::most_noise;
using references::noise_of;
using references::times_too_noisy;

namespace {

image::Image flat(float value, float variance) {
  auto image = image::make_image(32, 32, {"R", "G", "B", "variance.R", "variance.G", "variance.B"});
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = i % 6 < 3 ? value : variance;
  return image;
}

}  // namespace

// 32 x 32 pixels of a mean of 0.5 with a standard error of 0.04 each: 0.04 / 32 / 0.5 of the mean, and of a
// tile of 16 x 16 px 0.04 / 16 / (0.5 + 0.5).
TEST(ReferenceNoise, IsThatOfTheMeanAndOfTheWorstTile) {
  auto image = flat(0.5F, 0.0016F);
  const auto noise = noise_of(image);
  EXPECT_NEAR(noise.mean, 0.0025, 1e-6);
  EXPECT_NEAR(noise.tile, 0.0025, 1e-6);
  for (std::size_t x = 16; x < 32; ++x)
    for (std::size_t y = 16; y < 32; ++y) image.pixels[6 * (32 * y + x) + 4] = 0.0064F;  // of green
  EXPECT_NEAR(noise_of(image).tile, 0.005, 1e-6);
  EXPECT_NEAR(noise_of(image).mean, 0.0025 * std::sqrt(7.0 / 4), 1e-6);
}

// Beside a bright tile the noise of a dark one hardly counts: what is visible beside it is the measure.
TEST(ReferenceNoise, OfATileIsRelativeToTheWholeImageToo) {
  auto image = flat(0.5F, 0);
  for (std::size_t x = 16; x < 32; ++x)
    for (std::size_t y = 16; y < 32; ++y)
      for (std::size_t c = 0; c < 3; ++c) {
        image.pixels[6 * (32 * y + x) + c] = 0;
        image.pixels[6 * (32 * y + x) + 3 + c] = 0.0016F;
      }
  EXPECT_NEAR(noise_of(image).tile, 0.04 / 16 / 0.375, 1e-6);
}

// Half of the variance of 0.7 % over 3.8 standard errors, and of 10 % over 3.8 + 3.6 for the tiles.
TEST(ReferenceNoise, MayBeHalfOfTheVarianceThatTheGatesLeaveRoomFor) {
  const auto most = most_noise(registry::default_gates());
  EXPECT_EQ(most.psnr_db, 45);
  EXPECT_NEAR(most.mean, 0.007 / std::sqrt(2.0) / 3.76, 1e-5);
  EXPECT_NEAR(most.tile, 0.1 / std::sqrt(2.0) / 7.36, 1e-4);
  EXPECT_EQ(most_noise({}).mean, std::numeric_limits<double>::infinity());
}

TEST(ReferenceNoise, NeedsSamplesByItsWorstPart) {
  const references::ReferenceNoise most{45, 0.001, 0.01};
  EXPECT_NEAR(times_too_noisy({45, 0.001, 0.01}, most), 1, 1e-12);
  EXPECT_NEAR(times_too_noisy({42, 0.0005, 0.005}, most), 2, 0.01);
  EXPECT_NEAR(times_too_noisy({60, 0.003, 0.005}, most), 9, 1e-9);
  EXPECT_NEAR(times_too_noisy({60, 0.001, 0.02}, most), 4, 1e-9);
  EXPECT_LT(times_too_noisy({60, 1, 1}, kAnyNoise), 1);
  EXPECT_EQ(stricter(most, {50, 0.002, 0.005}).tile, 0.005);
  EXPECT_EQ(references::noise_text({45, 0.0012, kAnyNoise.tile}), "45.00 dB, 0.12 % of the mean");
}
