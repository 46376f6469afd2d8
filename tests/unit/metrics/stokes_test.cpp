#include "metrics/stokes.h"

#include <random>

#include <gtest/gtest.h>

namespace {

using namespace orbs;

// Grey of 0.5 with these Stokes parameters, and S1 up and down by `ripple` from pixel to pixel.
image::Image polarised(float s1, float s2, float s3, float ripple = 0) {
  constexpr int kSide = 16;
  std::vector<std::string> channels;
  for (const char* layer : {"", "S1.", "S2.", "S3."})
    for (const char* colour : {"R", "G", "B"}) channels.push_back(std::string(layer) + colour);
  auto image = image::make_image(kSide, kSide, channels);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        image.at(x, y, c) = 0.5F;
        image.at(x, y, 3 + c) = s1 + ((x + y) % 2 == 0 ? ripple : -ripple);
        image.at(x, y, 6 + c) = s2;
        image.at(x, y, 9 + c) = s3;
      }
  return image;
}

}  // namespace

TEST(Stokes, TheErrorIsTheRootMeanSquareOfTheThreeOverTheLight) {
  // sqrt((0.03^2 + 0.04^2 + 0) / 3) / 0.5
  const auto error = metrics::stokes_error(
      metrics::pair_samples(polarised(0.13F, 0.24F, 0.1F), polarised(0.1F, 0.2F, 0.1F)));
  ASSERT_TRUE(error);
  EXPECT_NEAR(*error, std::sqrt(0.0025 / 3) / 0.5, 1e-6);
}

TEST(Stokes, AMirroredConventionIsAnError) {
  EXPECT_GT(*metrics::stokes_error(metrics::pair_samples(polarised(0, 0, -0.1F), polarised(0, 0, 0.1F))),
            0.2);
}

TEST(Stokes, NoiseFromPixelToPixelAveragesOut) {
  EXPECT_NEAR(*metrics::stokes_error(metrics::pair_samples(polarised(0, 0, 0, 0.2F), polarised(0, 0, 0))), 0,
              1e-6);
}

TEST(Stokes, MaskedPixelsDoNotCount) {
  auto wrong = polarised(0, 0, 0);
  wrong.at(3, 3, 3) = 1;
  EXPECT_GT(*metrics::stokes_error(metrics::pair_samples(wrong, polarised(0, 0, 0))), 1e-3);
  EXPECT_EQ(*metrics::stokes_error(metrics::pair_samples(wrong, polarised(0, 0, 0), {{{3, 3, 4, 4}}, {}})),
            0);
}

namespace {

// 64 x 64 px, S1 and S3 by the place, with noise from pixel to pixel; S1 and S3 times these factors.
image::Image noisy_polarised(float s1, float s3, std::uint32_t seed) {
  auto image = image::make_image(64, 64, polarised(0, 0, 0).channels);
  std::mt19937 random(seed);
  std::normal_distribution<float> noise(0, 0.01F);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        image.at(x, y, c) = 0.5F;
        image.at(x, y, 3 + c) = s1 * 0.001F * static_cast<float>(x) + noise(random);
        image.at(x, y, 6 + c) = noise(random);
        image.at(x, y, 9 + c) = s3 * 0.01F + noise(random);
      }
  return image;
}

double certain_scale_error(float s1, float s3) {
  return metrics::stokes_scale(metrics::pair_samples(noisy_polarised(s1, s3, 1), noisy_polarised(1, 1, 2)))
      ->certain;
}

}  // namespace

// 1 % of the light, which the root mean square over blocks does not show.
TEST(Stokes, AParameterThatIsTooSmallOrMissingIsSeen) {
  EXPECT_EQ(certain_scale_error(1, 1), 0);
  EXPECT_GT(certain_scale_error(0.9F, 1), 0.03);
  EXPECT_GT(certain_scale_error(1, 0), 0.5);
  EXPECT_LT(*metrics::stokes_error(metrics::pair_samples(noisy_polarised(1, 0, 1), noisy_polarised(1, 1, 2))),
            0.02);
  // S2 is noise alone: of it nothing is said.
  EXPECT_NE(metrics::stokes_scale(metrics::pair_samples(noisy_polarised(1, 0, 1), noisy_polarised(1, 1, 2)))
                ->parameter,
            2);
}

TEST(Stokes, ImagesWithoutTheLayersHaveNone) {
  const auto plain = image::make_image(2, 2, {"R", "G", "B"});
  EXPECT_FALSE(metrics::has_stokes(plain));
  EXPECT_FALSE(metrics::stokes_error(metrics::pair_samples(plain, plain)));
}
