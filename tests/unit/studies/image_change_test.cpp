#include "studies/effects/image_change.h"

#include "base/random.h"

#include <gtest/gtest.h>

namespace {

using namespace orbs;

// Grey with noise of its own for each seed, and a patch of 8 x 8 px that is brighter.
image::Image noisy_image(std::uint64_t seed, float noise, float patch = 0) {
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

std::vector<image::Image> images(float noise, float patch = 0) {
  return {noisy_image(1, noise, patch), noisy_image(2, noise, patch), noisy_image(3, noise, patch)};
}

}  // namespace

TEST(ImageChange, TheSameImagesAreEqualToTheBit) {
  const auto change = studies::change_between(images(0.1F), images(0.1F));
  EXPECT_TRUE(change.is_equal);
  EXPECT_EQ(change.mean.value, 0);
  EXPECT_EQ(change.bias, "");
}

// With the same random numbers the noise drops out of the difference: one block of 16, 0.1 of 0.5.
TEST(ImageChange, AChangeIsFoundWhereItIs) {
  const auto change = studies::change_between(images(0.1F), images(0.1F, 0.1F));
  EXPECT_FALSE(change.is_equal);
  EXPECT_NEAR(change.largest.value, 0.2, 2e-3);
  EXPECT_LT(change.largest.standard_error, 1e-4);
  EXPECT_EQ(change.x, 8);
  EXPECT_EQ(change.y, 16);
  EXPECT_NEAR(change.mean.value, 0.2 / 16, 2e-4);
  EXPECT_NE(change.bias, "");
}

TEST(ImageChange, OtherNoiseIsNoChange) {
  const std::vector<image::Image> other{noisy_image(11, 0.1F), noisy_image(12, 0.1F), noisy_image(13, 0.1F)};
  EXPECT_EQ(studies::change_between(images(0.1F), other).bias, "");
}

TEST(ImageChange, ImagesWithoutNoiseDifferByAnything) {
  EXPECT_NE(studies::change_between(images(0), images(0, 0.1F)).bias, "");
  EXPECT_EQ(studies::change_between(images(0), images(0)).bias, "");
}

TEST(ImageChange, CausticsThatOnlyLightPathsFindAreNotCompared) {
  auto usual = images(0.1F);
  for (auto& one : usual) one.attributes["orbs.light_paths"] = "yes";
  EXPECT_FALSE(studies::change_between(usual, images(0.1F, 0.1F)).is_comparable);
  EXPECT_TRUE(studies::change_between(usual, usual).is_comparable);
  auto connected = images(0.1F);
  for (auto& one : connected) one.attributes["orbs.light_connections"] = "yes";
  EXPECT_FALSE(studies::change_between(connected, images(0.1F, 0.1F)).is_comparable);
}

TEST(ImageChange, TheVarianceIsThatOfAllImages) {
  EXPECT_NEAR(studies::mean_variance(images(0.6F)), 0.36 / 12, 1e-6);
}

// Stokes vectors lie between colour and variance.
TEST(ImageChange, TheVarianceIsFoundBehindOtherLayers) {
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
