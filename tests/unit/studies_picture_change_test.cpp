#include "base/random.h"
#include "studies/picture_change.h"

#include <gtest/gtest.h>

namespace {

using namespace orbs;

// Grey with noise of its own for each seed, and a patch of 8 x 8 px that is brighter.
image::Image picture(std::uint64_t seed, float noise, float patch = 0) {
  auto made = image::make_image(32, 32, {"R", "G", "B", "variance.R", "variance.G", "variance.B"});
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        const auto bits = mix(seed, static_cast<std::uint64_t>((y * 32 + x) * 3) + c) >> 40;
        const bool is_patch = x >= 8 && x < 16 && y >= 16 && y < 24;
        made.at(x, y, c) =
            0.5F + noise * (static_cast<float>(bits) * 0x1p-24F - 0.5F) + (is_patch ? patch : 0);
        made.at(x, y, 3 + c) = noise * noise / 12;
      }
  return made;
}

std::vector<image::Image> pictures(float noise, float patch = 0) {
  return {picture(1, noise, patch), picture(2, noise, patch), picture(3, noise, patch)};
}

}  // namespace

TEST(PictureChange, TheSamePicturesAreEqualToTheBit) {
  const auto change = studies::change_between(pictures(0.1F), pictures(0.1F));
  EXPECT_TRUE(change.is_equal);
  EXPECT_EQ(change.mean.value, 0);
  EXPECT_EQ(change.bias, "");
}

// With the same random numbers the noise drops out of the difference: one block of 16, 0.1 of 0.5.
TEST(PictureChange, AChangeIsFoundWhereItIs) {
  const auto change = studies::change_between(pictures(0.1F), pictures(0.1F, 0.1F));
  EXPECT_FALSE(change.is_equal);
  EXPECT_NEAR(change.largest.value, 0.2, 2e-3);
  EXPECT_LT(change.largest.standard_error, 1e-4);
  EXPECT_EQ(change.x, 8);
  EXPECT_EQ(change.y, 16);
  EXPECT_NEAR(change.mean.value, 0.2 / 16, 2e-4);
  EXPECT_NE(change.bias, "");
}

TEST(PictureChange, OtherNoiseIsNoChange) {
  const std::vector<image::Image> other{picture(11, 0.1F), picture(12, 0.1F), picture(13, 0.1F)};
  EXPECT_EQ(studies::change_between(pictures(0.1F), other).bias, "");
}

TEST(PictureChange, PicturesWithoutNoiseDifferByAnything) {
  EXPECT_NE(studies::change_between(pictures(0), pictures(0, 0.1F)).bias, "");
  EXPECT_EQ(studies::change_between(pictures(0), pictures(0)).bias, "");
}

TEST(PictureChange, CausticsThatOnlyLightPathsFindAreNotCompared) {
  auto usual = pictures(0.1F);
  for (auto& one : usual) one.attributes["orbs.light_paths"] = "yes";
  EXPECT_FALSE(studies::change_between(usual, pictures(0.1F, 0.1F)).is_comparable);
  EXPECT_TRUE(studies::change_between(usual, usual).is_comparable);
}

TEST(PictureChange, TheVarianceIsThatOfAllPictures) {
  EXPECT_NEAR(studies::mean_variance(pictures(0.6F)), 0.36 / 12, 1e-6);
}

// Stokes vectors lie between colour and variance.
TEST(PictureChange, TheVarianceIsFoundBehindOtherLayers) {
  auto made = image::make_image(
      4, 4, {"R", "G", "B", "S1.R", "S1.G", "S1.B", "variance.R", "variance.G", "variance.B"});
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        made.at(x, y, 3 + c) = -7;
        made.at(x, y, 6 + c) = 0.25F;
      }
  EXPECT_EQ(studies::mean_variance({made}), 0.25);
}
