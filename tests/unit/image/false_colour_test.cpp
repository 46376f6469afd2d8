#include "image/false_colour.h"

#include "base/error.h"
#include "image/colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace {

using namespace orbs::image;
using orbs::InputError;

// CIE L* of a display-encoded colour: an independent measure of lightness (the scales are built in OKLab).
double cie_lightness(const std::array<float, 3>& encoded) {
  const double y = luminance(srgb_decode(encoded[0]), srgb_decode(encoded[1]), srgb_decode(encoded[2]));
  return y > 216.0 / 24389.0 ? 116.0 * std::cbrt(y) - 16.0 : y * 24389.0 / 27.0;
}

std::array<float, 3> pixel(const Image& image, int x, int y) {
  return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
}

void expect_near(const std::array<float, 3>& a, const std::array<float, 3>& b) {
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], 1.0F / 255.0F);
}

// The dots of a one-channel image as text, a row per line.
std::string dots(const Image& image) {
  std::string text;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) text += image.at(x, y, 0) > 0.5F ? '#' : '.';
    text += '\n';
  }
  return text;
}

// True when `word`, drawn at some place right of `from_x` and below `from_y`, is in the image exactly, dot
// by dot.
bool shows_text(const Image& image, int from_x, const std::string& word, int zoom, int from_y = 0) {
  Image drawn = make_image(text_width_px(word, zoom), kGlyphHeightPx * zoom, {"Y"});
  draw_text(drawn, 0, 0, word, zoom, 1.0F);
  const auto matches = [&](int left, int top) {
    for (int y = 0; y < drawn.height; ++y)
      for (int x = 0; x < drawn.width; ++x)
        if ((drawn.at(x, y, 0) > 0.5F) != (image.at(left + x, top + y, 0) > 0.5F)) return false;
    return true;
  };
  for (int top = from_y; top + drawn.height <= image.height; ++top)
    for (int left = from_x; left + drawn.width <= image.width; ++left)
      if (matches(left, top)) return true;
  return false;
}

}  // namespace

TEST(ImageFalseColour, NoColourOfEitherScaleLeavesTheDisplaysRange) {
  for (const auto scale : {ColourScale::Sequential, ColourScale::Diverging})
    for (int i = -1000; i <= 1000; ++i)
      for (const float channel : colour_at(scale, static_cast<float>(i) / 1000.0F)) {
        EXPECT_GE(channel, 0.0F) << i;
        EXPECT_LE(channel, 1.0F) << i;
      }
}

TEST(ImageFalseColour, TheSequentialScaleGetsLighterInEvenSteps) {
  constexpr int kSteps = 20;
  const double first = cie_lightness(colour_at(ColourScale::Sequential, 0.0F));
  const double last = cie_lightness(colour_at(ColourScale::Sequential, 1.0F));
  EXPECT_LT(first, 5.0);
  EXPECT_GT(last, 90.0);
  double before = first;
  for (int i = 1; i <= kSteps; ++i) {
    const double lightness =
        cie_lightness(colour_at(ColourScale::Sequential, static_cast<float>(i) / kSteps));
    const double step = lightness - before;
    // Even means here: no step is under half or over twice the mean one, so no false edges and no flat parts.
    const double mean_step = (last - first) / kSteps;
    EXPECT_GT(step, 0.5 * mean_step) << i;
    EXPECT_LT(step, 2.0 * mean_step) << i;
    before = lightness;
  }
}

TEST(ImageFalseColour, TheDivergingScaleIsDarkAtZeroBlueBelowAndOrangeAbove) {
  const auto zero = colour_at(ColourScale::Diverging, 0.0F);
  EXPECT_NEAR(zero[0], zero[1], 0.002F);
  EXPECT_NEAR(zero[1], zero[2], 0.002F);
  for (const float t : {0.25F, 0.5F, 1.0F}) {
    const auto below = colour_at(ColourScale::Diverging, -t);
    const auto above = colour_at(ColourScale::Diverging, t);
    EXPECT_GT(below[2], below[0]);
    EXPECT_GT(above[0], above[2]);
    EXPECT_NEAR(cie_lightness(below), cie_lightness(above), 4.0) << t;
    EXPECT_GT(cie_lightness(above), cie_lightness(zero) + 10.0 * static_cast<double>(t));
  }
}

TEST(ImageFalseColour, EachPixelHasTheColourOfItsShareOfTheMaximum) {
  Image map = make_image(5, 1, {"Y"});
  map.pixels = {0.0F, 0.1F, 0.2F, 5.0F, std::nanf("")};
  const Image image = false_colour(map, ColourScale::Sequential, 0.2F);
  expect_near(pixel(image, 0, 0), colour_at(ColourScale::Sequential, 0.0F));
  expect_near(pixel(image, 1, 0), colour_at(ColourScale::Sequential, 0.5F));
  expect_near(pixel(image, 2, 0), colour_at(ColourScale::Sequential, 1.0F));
  expect_near(pixel(image, 3, 0), colour_at(ColourScale::Sequential, 1.0F));
  expect_near(pixel(image, 4, 0), {0.5F, 0.5F, 0.5F});
}

TEST(ImageFalseColour, ThreeChannelsShowTheOneOfLargestMagnitudeWithItsSign) {
  Image map = make_image(2, 1, {"R", "G", "B"});
  map.pixels = {0.05F, -0.1F, 0.05F, 0.0F, 0.0F, 0.1F};
  const Image image = false_colour(map, ColourScale::Diverging, 0.1F);
  expect_near(pixel(image, 0, 0), colour_at(ColourScale::Diverging, -1.0F));
  expect_near(pixel(image, 1, 0), colour_at(ColourScale::Diverging, 1.0F));
}

TEST(ImageFalseColour, TheBarIsLabelledWithBothEndsAndRunsLinearlyBetweenThem) {
  const Image map = make_image(40, 101, {"Y"});
  const Image image = false_colour(map, ColourScale::Sequential, 0.25F);
  EXPECT_EQ(image.height, 101);
  const int bar_x = 40 + 6 + 2;
  expect_near(pixel(image, bar_x, 0), colour_at(ColourScale::Sequential, 1.0F));
  expect_near(pixel(image, bar_x, 50), colour_at(ColourScale::Sequential, 0.5F));
  expect_near(pixel(image, bar_x, 100), colour_at(ColourScale::Sequential, 0.0F));
  EXPECT_TRUE(shows_text(image, bar_x + 10, "0.25", 1));
  EXPECT_TRUE(shows_text(image, bar_x + 10, "0", 1, 90));
  EXPECT_FALSE(shows_text(image, bar_x + 10, "0.26", 1));
}

TEST(ImageFalseColour, TheDivergingBarIsLabelledWithBothSigns) {
  const Image image = false_colour(make_image(40, 64, {"R", "G", "B"}), ColourScale::Diverging, 3e-5F);
  EXPECT_TRUE(shows_text(image, 40 + 6 + 12, "+3e-05", 1));
  EXPECT_TRUE(shows_text(image, 40 + 6 + 12, "-3e-05", 1));
}

TEST(ImageFalseColour, TinyImagesGetACanvasHighEnoughForTheDigits) {
  const Image image = false_colour(make_image(1, 1, {"Y"}), ColourScale::Sequential, 1.0F);
  EXPECT_GE(image.height, 3 * kGlyphHeightPx);
  EXPECT_TRUE(shows_text(image, 1 + 6 + 12, "1", 1));
}

TEST(ImageFalseColour, LargeImagesGetLargerDigits) {
  const Image image = false_colour(make_image(8, 512, {"Y"}), ColourScale::Sequential, 7.0F);
  EXPECT_TRUE(shows_text(image, 8 + 12 + 24, "7", 2));
}

TEST(ImageFalseColour, AMaximumOfZeroColoursEqualImages) {
  const Image image = false_colour(make_image(4, 4, {"Y"}), ColourScale::Sequential, 0.0F);
  expect_near(pixel(image, 2, 2), colour_at(ColourScale::Sequential, 0.0F));
}

TEST(ImageFalseColour, TwoChannelsAndImpossibleMaximaAreRefused) {
  EXPECT_THROW(false_colour(make_image(4, 4, {"X", "Y"}), ColourScale::Sequential, 1.0F), InputError);
  const Image map = make_image(4, 4, {"Y"});
  EXPECT_THROW(false_colour(map, ColourScale::Sequential, -1.0F), InputError);
  EXPECT_THROW(false_colour(map, ColourScale::Sequential, std::nanf("")), InputError);
  EXPECT_THROW(false_colour(map, ColourScale::Sequential, std::numeric_limits<float>::infinity()),
               InputError);
}

TEST(ImageFalseColour, TheLargestMagnitudeIgnoresSignAndWhatIsNotFinite) {
  Image map = make_image(4, 1, {"Y"});
  map.pixels = {0.5F, -2.0F, std::nanf(""), std::numeric_limits<float>::infinity()};
  EXPECT_EQ(largest_magnitude(map), 2.0F);
  EXPECT_EQ(largest_magnitude(make_image(2, 2, {"Y"})), 0.0F);
}

TEST(ImageFalseColour, DigitsAreDrawnFiveBySevenDots) {
  Image image = make_image(text_width_px("17", 1), kGlyphHeightPx, {"Y"});
  ASSERT_EQ(image.width, 11);
  draw_text(image, 0, 0, "17", 1, 1.0F);
  EXPECT_EQ(dots(image),
            "..#...#####\n"
            ".##.......#\n"
            "..#......#.\n"
            "..#.....#..\n"
            "..#....#...\n"
            "..#....#...\n"
            ".###...#...\n");
}

TEST(ImageFalseColour, TextBeyondTheImageIsCutOff) {
  Image image = make_image(6, 6, {"Y"});
  draw_text(image, -2, -3, "8", 2, 1.0F);
  draw_text(image, 5, 5, "8", 2, 1.0F);
  EXPECT_NE(std::count(image.pixels.begin(), image.pixels.end(), 1.0F), 0);
}
