#include "base/error.h"
#include "image/image.h"

#include <gtest/gtest.h>

using namespace orbs;

// The mean of x + 10 y over 4 x 4 px is its value in their middle, 1.5 px from the first in both directions.
TEST(ReducedImage, HoldsTheMeansOfSquares) {
  auto full = image::make_image(8, 4, {"R", "S1.R"});
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 8; ++x)
      for (std::size_t c = 0; c < 2; ++c) full.at(x, y, c) = static_cast<float>(c == 0 ? x + 10 * y : -x);
  full.attributes["orbs.spp"] = "64";
  const auto reduced = image::reduced_image(full, 4);
  EXPECT_EQ(reduced.width, 2);
  EXPECT_EQ(reduced.height, 1);
  EXPECT_EQ(reduced.channels, full.channels);
  EXPECT_EQ(reduced.attributes, full.attributes);
  EXPECT_EQ(reduced.at(0, 0, 0), 16.5F);
  EXPECT_EQ(reduced.at(1, 0, 0), 20.5F);
  EXPECT_EQ(reduced.at(0, 0, 1), -1.5F);
  EXPECT_EQ(reduced.at(1, 0, 1), -5.5F);
}

// Var[(X1 + ... + Xn) / n] = (Var X1 + ... + Var Xn) / n^2 for independent pixels, here with n = 4 and
// variances 1, 2, 3, 4.
TEST(ReducedImage, HasTheVarianceOfEachMean) {
  auto full = image::make_image(2, 2, {"variance.R"});
  full.pixels = {1, 2, 3, 4};
  EXPECT_EQ(image::reduced_image(full, 2).at(0, 0, 0), 10.0F / 16);
}

TEST(ReducedImage, KeepsWholePixels) {
  const auto full = image::make_image(12, 8, {"R"});
  EXPECT_THROW(image::reduced_image(full, 8), InputError);  // 12
  EXPECT_THROW(image::reduced_image(image::make_image(8, 12, {"R"}), 8), InputError);
  EXPECT_EQ(image::reduced_image(full, 1).pixels, full.pixels);
}
