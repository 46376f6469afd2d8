#include "metrics/mask.h"

#include "base/error.h"
#include "metrics/compare.h"
#include "metrics/table.h"
#include "unit/metrics/images.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace {

using namespace orbs::metrics;
using namespace orbs::metrics_test;
using orbs::InputError;
using orbs::image::Image;

Image with_wrong_pixel(Image image, int x, int y) {
  for (std::size_t c = 0; c < 3; ++c) image.at(x, y, c) += 0.5F;
  return image;
}

std::string error_of(const Mask& mask) {
  try {
    included_pixels(mask, 8, 6);
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

}  // namespace

TEST(MetricsMask, RectanglesEndBeforeTheirSecondCorner) {
  const auto included = included_pixels({{{1, 2, 3, 4}}, {}}, 5, 5);
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 5; ++x) {
      const bool masked = (x == 1 || x == 2) && (y == 2 || y == 3);
      EXPECT_EQ(included[static_cast<std::size_t>(5 * y + x)], masked ? 0 : 1) << x << ", " << y;
    }
}

TEST(MetricsMask, BytesAndRectanglesAddUp) {
  Mask mask{{{0, 0, 1, 1}, {0, 0, 2, 1}}, std::vector<std::uint8_t>(48, 0)};
  mask.pixels[47] = 255;
  const auto included = included_pixels(mask, 8, 6);
  EXPECT_EQ(std::count(included.begin(), included.end(), 0), 3);
  EXPECT_EQ(included[47], 0);
}

TEST(MetricsMask, WhatDoesNotFitTheImageIsRefused) {
  EXPECT_EQ(error_of({{{2, 1, 9, 4}}, {}}),
            "the masked rectangle [2, 1, 9, 4] is not inside the 8 x 6 px image; expected [x0, y0, x1, y1] "
            "with 0 <= x0 < x1 <= 8 and 0 <= y0 < y1 <= 6");
  for (const orbs::Rectangle& r : {orbs::Rectangle{-1, 0, 2, 2}, orbs::Rectangle{3, 3, 3, 4},
                                   orbs::Rectangle{0, 5, 1, 4}, orbs::Rectangle{0, 0, 1, 7}})
    EXPECT_NE(error_of({{r}, {}}), "no error");
  EXPECT_EQ(error_of({{}, std::vector<std::uint8_t>(47, 0)}), "the mask has 47 pixels, the image 48 (8 x 6)");
  EXPECT_EQ(error_of({{{0, 0, 8, 6}}, {}}), "the mask leaves no pixel to compare");
}

TEST(MetricsMask, AnErrorUnderTheMaskCountsInNoMeanOfPixels) {
  const Image reference = grey_image(24, 20, detail);
  const Comparison c = compare(with_wrong_pixel(reference, 4, 9), reference, {{{4, 9, 5, 10}}, {}});
  EXPECT_EQ(value_of(c, "l1"), 0.0);
  EXPECT_EQ(value_of(c, "mse"), 0.0);
  EXPECT_EQ(value_of(c, "psnr_srgb8"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(value_of(c, "psnr_linear"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(c.pixels_counted, 479U);
}

// Error 0.5 in one of the four pixels left of sixteen: 0.125, not 0.5 / 16.
TEST(MetricsMask, TheMeanIsOverThePixelsThatAreLeft) {
  const Image reference = constant_image(4, 4, 0.25F);
  const Comparison c =
      compare(with_wrong_pixel(reference, 1, 1), reference, {{{2, 0, 4, 4}, {0, 2, 4, 4}}, {}});
  EXPECT_DOUBLE_EQ(value_of(c, "l1").value(), 0.125);
}

TEST(MetricsMask, TheCentreDecidesWhetherAnSsimWindowCounts) {
  const Image reference = grey_image(40, 40, detail);
  const Image result = with_wrong_pixel(reference, 20, 20);
  const double unmasked = value_of(compare(result, reference), "ssim").value();
  // The pixel alone: its own window goes, those beside it still see it.
  const double pixel_masked = value_of(compare(result, reference, {{{20, 20, 21, 21}}, {}}), "ssim").value();
  EXPECT_GT(pixel_masked, unmasked);
  EXPECT_LT(pixel_masked, 1.0);
  // All centres within 5 px: nothing of the error is left. One column less, and it is seen again.
  EXPECT_EQ(value_of(compare(result, reference, {{{15, 15, 26, 26}}, {}}), "ssim"), 1.0);
  EXPECT_LT(value_of(compare(result, reference, {{{15, 15, 25, 26}}, {}}), "ssim").value(), 1.0);
}

TEST(MetricsMask, WithoutAnyCentreLeftSsimHasNoValueWhileOthersHave) {
  const Image image = grey_image(20, 20, detail);
  const Comparison c = compare(image, image, {{{5, 5, 15, 15}}, {}});
  EXPECT_FALSE(value_of(c, "ssim").has_value());
  EXPECT_EQ(value_of(c, "l1"), 0.0);
}

TEST(MetricsMask, MapsShowMaskedPixelsAsAnyOther) {
  const Image reference = constant_image(12, 12, 0.25F);
  const Comparison c = compare(with_wrong_pixel(reference, 6, 6), reference, {{{6, 6, 7, 7}}, {}});
  EXPECT_EQ(c.maps.front().info.name, "l1");
  EXPECT_FLOAT_EQ(c.maps.front().image.at(6, 6, 0), 0.5F);
}
