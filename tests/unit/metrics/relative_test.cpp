#include "metrics/compare.h"
#include "metrics/psnr.h"
#include "unit/metrics/images.h"

#include <cmath>

#include <gtest/gtest.h>

namespace {

using namespace orbs::metrics;
using namespace orbs::metrics_test;
using orbs::image::Image;

Comparison compare_all(const Image& result, const Image& reference, const Mask& mask = {}) {
  return compare(result, reference, mask, {.all = true});
}

double number(const Comparison& comparison, std::string_view metric) {
  return value_of(comparison, metric).value();
}

void set_pixel(Image& image, int x, int y, float value) {
  for (std::size_t c = 0; c < 3; ++c) image.at(x, y, c) = value;
}

const Measurement& measurement(const Comparison& comparison, std::string_view metric) {
  for (const auto& one : comparison.measurements)
    if (one.metric->name == metric) return one;
  throw std::runtime_error("not computed");
}

}  // namespace

// 0.1^2 / (0.2^2 + 0.01) = 0.2, and with the images exchanged 0.1^2 / (0.3^2 + 0.01) = 0.1.
TEST(MetricsRelative, RelMseDividesByTheReferenceSquaredAndAHundredth) {
  const Image dark = constant_image(4, 4, 0.2F);
  const Image bright = constant_image(4, 4, 0.3F);
  EXPECT_NEAR(number(compare(bright, dark), "relmse_eps01"), 0.2, 1e-6);
  EXPECT_NEAR(number(compare(dark, bright), "relmse_eps01"), 0.1, 1e-6);
}

// Light of 0.02 on black: 0.0004 / 0.01, epsilon alone decides.
TEST(MetricsRelative, OnBlackEpsilonDecidesRelMse) {
  EXPECT_NEAR(number(compare(constant_image(4, 4, 0.02F), constant_image(4, 4, 0.0F)), "relmse_eps01"), 0.04,
              1e-7);
}

// 50 x 40 = 2000 pixels: the two brightest errors are dropped, the third stays. 0.5^2 / (0.3^2 + 0.01) = 2.5.
TEST(MetricsRelative, TrimmingDropsTheWorstThousandthOfThePixelsAndNoMore) {
  const Image reference = constant_image(50, 40, 0.3F);
  Image result = reference;
  set_pixel(result, 3, 3, 1000.0F);
  set_pixel(result, 40, 20, 2000.0F);
  EXPECT_DOUBLE_EQ(number(compare(result, reference), "relmse_eps01_trimmed"), 0.0);
  EXPECT_GT(number(compare(result, reference), "relmse_eps01"), 1e4);
  set_pixel(result, 7, 31, 0.8F);
  EXPECT_NEAR(number(compare(result, reference), "relmse_eps01_trimmed"), 2.5 / 1998, 1e-7);
}

TEST(MetricsRelative, TrimmingOfEqualErrorsIsTheirMean) {
  const Comparison c = compare(constant_image(50, 40, 0.3F), constant_image(50, 40, 0.2F));
  EXPECT_NEAR(number(c, "relmse_eps01_trimmed"), number(c, "relmse_eps01"), 1e-12);
}

// 2 * 0.1 / (0.3 + 0.2 + 0.02) = 0.384615; all or nothing: 2 * 1 / 1.02.
TEST(MetricsRelative, SmapeGoesUpToTwo) {
  EXPECT_NEAR(number(compare(constant_image(4, 4, 0.3F), constant_image(4, 4, 0.2F)), "smape"), 0.2 / 0.52,
              1e-6);
  EXPECT_NEAR(number(compare(constant_image(4, 4, 1.0F), constant_image(4, 4, 0.0F)), "smape"), 2 / 1.02,
              1e-6);
}

// Errors 1/128 ... 100/128 in an image of 10 x 10: the 95th and the 99th of them, and the last.
TEST(MetricsRelative, QuantilesAreErrorsThatOccurAndTheLargestSaysWhere) {
  const Image reference = constant_image(10, 10, 0.0F);
  Image result = reference;
  for (int i = 0; i < 100; ++i)  // 37 and 100 have no common divisor: every error once
    result.at(i % 10, i / 10, static_cast<std::size_t>(i % 3)) =
        static_cast<float>(1 + i * 37 % 100) / 128.0F;
  const Comparison c = compare(result, reference);
  EXPECT_DOUBLE_EQ(number(c, "error_p95"), 95.0 / 128);
  EXPECT_DOUBLE_EQ(number(c, "error_p99"), 99.0 / 128);
  EXPECT_DOUBLE_EQ(number(c, "error_max"), 100.0 / 128);
  // 1 + 37 i = 100 (mod 100) where i = 27: 37 * 27 = 999.
  const auto where = measurement(c, "error_max").where.value();
  EXPECT_EQ(where.x0, 7);
  EXPECT_EQ(where.y0, 2);
  EXPECT_EQ(where.x1, 8);
  EXPECT_EQ(where.y1, 3);
  EXPECT_LT(number(compare(result, reference, {{{7, 2, 8, 3}}, {}}), "error_max"), 100.0 / 128);
}

// A 16 x 16 leak of 0.25 fills one tile; the tiles at the lower right corner are 4 x 4 pixels and do not
// count.
TEST(MetricsRelative, TheWorstTileIsFoundAndScrapsAtTheBorderAreNoTiles) {
  const Image reference = constant_image(52, 36, 0.5F);
  Image result = reference;
  for (int y = 16; y < 32; ++y)
    for (int x = 32; x < 48; ++x) set_pixel(result, x, y, 0.75F);
  for (int y = 32; y < 36; ++y)
    for (int x = 48; x < 52; ++x) set_pixel(result, x, y, 9.0F);
  const Comparison c = compare(result, reference);
  EXPECT_DOUBLE_EQ(number(c, "l1_worst_tile"), 0.25);
  const auto where = measurement(c, "l1_worst_tile").where.value();
  EXPECT_EQ(where.x0, 32);
  EXPECT_EQ(where.y0, 16);
  EXPECT_EQ(where.x1, 48);
  EXPECT_EQ(where.y1, 32);
  EXPECT_FALSE(value_of(compare(constant_image(7, 9, 1), constant_image(7, 9, 1)), "l1_worst_tile"));
}

// The paper fits 256 to 100 cd/m^2 and 0 to 0.005 cd/m^2.
TEST(MetricsRelative, Pu21GivesTheValuesOfItsPaper) {
  EXPECT_NEAR(pu21::encode(100.0), 256.0, 0.5);
  EXPECT_NEAR(pu21::encode(0.005), 0.0, 0.01);
  EXPECT_NEAR(pu21::encode(10000.0), 595.4, 0.5);
  EXPECT_EQ(pu21::encode(1e6), pu21::encode(10000.0));
  EXPECT_EQ(pu21::encode(0.0), pu21::encode(0.005));
}

// A highlight of 20 that came out as 2 is white on any display, which PU21 does not assume.
TEST(MetricsRelative, Pu21SeesAWrongHighlight) {
  Image reference = constant_image(8, 8, 0.25F);
  Image result = reference;
  set_pixel(reference, 3, 4, 20.0F);
  set_pixel(result, 3, 4, 2.0F);
  const double steps = pu21::encode(2000) - pu21::encode(200);
  EXPECT_NEAR(number(compare_all(result, reference), "psnr_pu21"), 20 * std::log10(256 / (steps / 8)), 1e-9);
  EXPECT_TRUE(std::isinf(number(compare_all(reference, reference), "psnr_pu21")));
}

// Constant images have no variance: what is left is (2 a b + c1) / (a^2 + b^2 + c1) of the values on the
// display.
TEST(MetricsRelative, JerisSsimOfConstantImagesIsItsFirstFactor) {
  const double a = std::pow(0.5, 1 / 2.2);
  const double b = std::pow(0.25, 1 / 2.2);
  EXPECT_NEAR(number(compare_all(constant_image(8, 8, 0.5F), constant_image(8, 8, 0.25F)), "ssim_jeri"),
              (2 * a * b + 1e-4) / (a * a + b * b + 1e-4), 1e-6);
}

// One white pixel in black against black: a window that holds it has the sum 1 and the square 1 in one
// image, so the mean is 1/25 and the variance (1 - 25/625) / 26. 25 windows of the 15 x 15 hold it, and
// repeated border pixels are black.
TEST(MetricsRelative, JerisSsimDividesBy26) {
  const Image black = constant_image(15, 15, 0.0F);
  Image result = black;
  set_pixel(result, 7, 7, 1.0F);
  const double variance = (1 - 1.0 / 25) / 26;
  const double index = 1e-4 * 9e-4 / ((1.0 / 625 + 1e-4) * (variance + 9e-4));
  EXPECT_NEAR(number(compare_all(result, black), "ssim_jeri"), (25 * index + 200) / 225, 1e-9);
  // In the corner the pixel is repeated into a window nine times at most.
  Image corner = black;
  set_pixel(corner, 0, 0, 1.0F);
  EXPECT_LT(number(compare_all(corner, black), "ssim_jeri"), 1.0);
}
