// Squared errors that edges make.
#include "image/image.h"
#include "metrics/noise_test.h"

#include <gtest/gtest.h>

using namespace orbs;

// An edge that lies a tenth of a pixel away is antialiasing, half a pixel is an error.
TEST(EdgeSquares, AreAnErrorWhereTheyAreMoreThanAntialiasing) {
  const auto stripes = [](double moved_px) {
    auto image = image::make_image(64, 64, {"R", "G", "B"});
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        const double light = x % 8 == 0 ? 1 - moved_px : x % 8 < 4 ? 1 : x % 8 == 4 ? moved_px : 0;
        for (std::size_t c = 0; c < 3; ++c) image.at(x, y, c) = static_cast<float>(light);
      }
    return image;
  };
  const auto is_seen = [&](double moved_px) {
    return metrics::is_square_biased_beyond_edges(
        metrics::test_noise(stripes(moved_px), stripes(0), {}, metrics::ResultNoise::NoiseFree));
  };
  EXPECT_FALSE(is_seen(0.1));
  EXPECT_TRUE(is_seen(0.5));
}
