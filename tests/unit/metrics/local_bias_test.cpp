// Tiles of a grey image with a part that is off, with and without noise.
#include "metrics/local_bias.h"

#include <random>

#include <gtest/gtest.h>

using namespace orbs;

namespace {

image::Image grey(int side, float value) {
  auto image = image::make_image(side, side, {"R", "G", "B"});
  image.pixels.assign(image.pixels.size(), value);
  return image;
}

}  // namespace

// 0.1 more in one whole tile, over 0.25 of the tile and 0.25 of the image.
TEST(LocalBias, IsMeasuredByTileAndImage) {
  auto result = grey(64, 0.25F);
  for (int y = 16; y < 32; ++y)
    for (int x = 32; x < 48; ++x) result.at(x, y, 2) += 0.1F;
  const auto bias = metrics::local_bias(metrics::pair_samples(result, grey(64, 0.25F)));
  ASSERT_TRUE(bias);
  EXPECT_NEAR(bias->value, 0.2, 1e-6);
  EXPECT_EQ(bias->where.x0, 32);
  EXPECT_EQ(bias->where.y1, 32);
  const auto masked =
      metrics::local_bias(metrics::pair_samples(result, grey(64, 0.25F), {{{32, 16, 48, 32}}, {}}));
  ASSERT_TRUE(masked);
  EXPECT_EQ(masked->value, 0);
}

TEST(LocalBias, NoiseIsNone) {
  std::mt19937 random(1);
  std::normal_distribution<float> noise(0, 0.1F);
  int off = 0;
  for (int i = 0; i < 100; ++i) {
    auto result = grey(64, 0.25F);
    for (auto& value : result.pixels) value += noise(random);
    if (metrics::local_bias(metrics::pair_samples(result, grey(64, 0.25F)))->value > 0) ++off;
  }
  EXPECT_LE(off, 1);
}

TEST(LocalBias, AFireflyIsNone) {
  auto result = grey(64, 0.25F);
  result.at(20, 20, 0) = 1000;
  EXPECT_EQ(metrics::local_bias(metrics::pair_samples(result, grey(64, 0.25F)))->value, 0);
}

TEST(LocalBias, OfABlackReferenceThereIsNone) {
  EXPECT_FALSE(metrics::local_bias(metrics::pair_samples(grey(64, 0.25F), grey(64, 0))));
}
