#include "metrics/stokes.h"

#include <cmath>

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

TEST(Stokes, ImagesWithoutTheLayersHaveNone) {
  const auto plain = image::make_image(2, 2, {"R", "G", "B"});
  EXPECT_FALSE(metrics::has_stokes(plain));
  EXPECT_FALSE(metrics::stokes_error(metrics::pair_samples(plain, plain)));
}
