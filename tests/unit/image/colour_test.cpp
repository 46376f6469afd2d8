#include "image/colour.h"

#include <cmath>

#include <gtest/gtest.h>

namespace {

using namespace orbs::image;

}  // namespace

// ORB.S: 12.92 c up to 0.0031308, else 1.055 c^(1/2.4) - 0.055.
TEST(ImageColour, EncodingFollowsTheTwoBranchesOfOrbs) {
  EXPECT_EQ(srgb_encode(0.0F), 0.0F);
  EXPECT_FLOAT_EQ(srgb_encode(0.001F), 0.01292F);
  EXPECT_FLOAT_EQ(srgb_encode(0.0031308F), 12.92F * 0.0031308F);
  // Just above the joint at 0.0031308 the two differ: 1.055 * 0.004^(1/2.4) - 0.055 = 0.0507087, 12.92 *
  // 0.004 = 0.0516800.
  EXPECT_NEAR(srgb_encode(0.004F), 0.0507087F, 1e-6F);
  // 0.5^(1/2.4) = 0.7491535, so 1.055 * 0.7491535 - 0.055 = 0.7353570.
  EXPECT_NEAR(srgb_encode(0.5F), 0.7353570F, 2e-7F);
  EXPECT_NEAR(srgb_encode(1.0F), 1.0F, 1e-6F);
}

// ((0.5 + 0.055) / 1.055)^2.4 = 0.5260664^2.4 = 0.2140411.
TEST(ImageColour, DecodingFollowsTheTwoBranchesOfOrbs) {
  EXPECT_FLOAT_EQ(srgb_decode(0.02F), 0.02F / 12.92F);
  EXPECT_FLOAT_EQ(srgb_decode(0.04045F), 0.04045F / 12.92F);
  // Just above the joint at 0.04045: (0.1 / 1.055)^2.4 = 0.00350102, 0.045 / 12.92 = 0.00348297.
  EXPECT_NEAR(srgb_decode(0.045F), 0.00350102F, 1e-7F);
  EXPECT_NEAR(srgb_decode(0.5F), 0.2140411F, 2e-7F);
}

TEST(ImageColour, DecodingUndoesEncoding) {
  for (int i = 0; i <= 1000; ++i) {
    const float value = static_cast<float>(i) / 1000.0F;
    EXPECT_NEAR(srgb_decode(srgb_encode(value)), value, 1e-6F) << value;
  }
}

TEST(ImageColour, LuminanceOfWhiteIsOneAndGreenWeighsMost) {
  EXPECT_DOUBLE_EQ(luminance(1, 1, 1), 1.0);
  EXPECT_DOUBLE_EQ(luminance(1, 0, 0), 0.2126);
  EXPECT_DOUBLE_EQ(luminance(0, 1, 0), 0.7152);
  EXPECT_DOUBLE_EQ(luminance(0, 0, 1), 0.0722);
}

TEST(ImageColour, ADisplayImageIsClampedEncodedAndMarksNan) {
  Image image = make_image(2, 1, {"B", "G", "R"});
  image.pixels = {0.5F, -1.0F, 7.0F, 0.0F, std::nanf(""), 0.0F};
  const Image shown = display_image(image);
  EXPECT_NEAR(shown.at(0, 0, 0), 1.0F, 1e-6F);
  EXPECT_EQ(shown.at(0, 0, 1), 0.0F);
  EXPECT_EQ(shown.at(0, 0, 2), srgb_encode(0.5F));
  EXPECT_EQ(shown.at(1, 0, 0), 1.0F);
  EXPECT_EQ(shown.at(1, 0, 1), 0.0F);
  EXPECT_EQ(shown.at(1, 0, 2), 1.0F);
}
