#include "metrics/compare.h"
#include "metrics/table.h"
#include "unit/metrics/images.h"

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace {

using namespace orbs::metrics;
using namespace orbs::metrics_test;
using orbs::image::Image;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double number(const Comparison& comparison, std::string_view metric) {
  return value_of(comparison, metric).value();
}

bool is_relative_to_reference(const MetricInfo& metric) {
  return metric.rule == GateRule::WholeInterval || metric.rule == GateRule::AnyOfInterval ||
         metric.name == "local_bias" || metric.name.starts_with("stokes") ||
         metric.name.starts_with("layer") || metric.name == "shared_noise" ||
         metric.name.starts_with("block") || metric.name.starts_with("pixel") ||
         metric.name.starts_with("smallest") || metric.name.starts_with("window") ||
         metric.name == "line_error" || metric.name == "pattern_error";
}

}  // namespace

TEST(MetricsNumbers, IdenticalImagesHaveNoErrorInfinitePsnrAndSsimOne) {
  const Image image = grey_image(32, 24, detail);
  const Comparison c = compare(image, image);
  EXPECT_EQ(number(c, "l1"), 0.0);
  EXPECT_EQ(number(c, "mse"), 0.0);
  EXPECT_EQ(number(c, "psnr_srgb8"), kInfinity);
  EXPECT_EQ(number(c, "psnr_linear"), kInfinity);
  EXPECT_EQ(number(c, "ssim"), 1.0);
}

// MSE = 0.1^2 on the scale where the peak is 1: 10 log10(1 / 0.01) = 20 dB.
TEST(MetricsNumbers, AConstantDifferenceOfATenthOnTheDisplayIsTwentyDecibels) {
  const Comparison c = compare(displayed_grey(16, 16, 0.6F), displayed_grey(16, 16, 0.5F));
  EXPECT_NEAR(number(c, "psnr_srgb8"), 20.0, 1e-4);
}

// Linear 0.6 against 0.5: L1 0.1, MSE 0.01, 20 dB; on the display by ORB.S's formula 0.7977377 and 0.7353570,
// so 20 log10(1 / 0.0623807) = 24.0991 dB: the two PSNRs are in different spaces.
TEST(MetricsNumbers, AConstantLinearDifferenceOfATenthIsTwentyLinearDecibels) {
  const Comparison c = compare(constant_image(16, 16, 0.6F), constant_image(16, 16, 0.5F));
  EXPECT_NEAR(number(c, "l1"), 0.1, 1e-7);
  EXPECT_NEAR(number(c, "mse"), 0.01, 1e-8);
  EXPECT_NEAR(number(c, "psnr_linear"), 20.0, 1e-5);
  EXPECT_NEAR(number(c, "psnr_srgb8"), 24.0991, 1e-3);
}

// One channel of three: the mean over channels is a third, 10 log10(3) = 4.7712 dB more.
TEST(MetricsNumbers, AllThreeChannelsAreAveraged) {
  Image result = displayed_grey(12, 12, 0.5F);
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 12; ++x) result.at(x, y, 1) = orbs::image::srgb_decode(0.6F);
  const Comparison c = compare(result, displayed_grey(12, 12, 0.5F));
  EXPECT_NEAR(number(c, "psnr_srgb8"), 20.0 + 10.0 * std::log10(3.0), 1e-4);
}

// 8 names the scale, not a rounding: half a step of 1/255 everywhere is 20 log10(255 / 0.5) = 54.1514 dB.
TEST(MetricsNumbers, ValuesAreNotRoundedToWholeSteps) {
  const Comparison c =
      compare(displayed_grey(12, 12, 100.3F / 255.0F), displayed_grey(12, 12, 99.8F / 255.0F));
  EXPECT_NEAR(number(c, "psnr_srgb8"), 20.0 * std::log10(255.0 / 0.5), 0.01);
}

// 8 x 8 pixels, one of them 20 instead of 2: MSE = 18^2 / 64 = 5.0625, L1 = 18 / 64 = 0.28125. Both are white
// on a display.
TEST(MetricsNumbers, AWrongHighlightIsSeenByLinearMetricsOnly) {
  Image reference = constant_image(8, 8, 0.25F);
  Image result = reference;
  for (std::size_t ch = 0; ch < 3; ++ch) {
    reference.at(3, 4, ch) = 2.0F;
    result.at(3, 4, ch) = 20.0F;
  }
  const Comparison c = compare(result, reference);
  EXPECT_EQ(number(c, "psnr_srgb8"), kInfinity);
  EXPECT_DOUBLE_EQ(number(c, "mse"), 5.0625);
  EXPECT_DOUBLE_EQ(number(c, "l1"), 0.28125);
  EXPECT_NEAR(number(c, "psnr_linear"), -10.0 * std::log10(5.0625), 1e-12);
}

TEST(MetricsNumbers, NegativeValuesAreBlackOnTheDisplayButCountLinearly) {
  const Comparison c =
      compare(constant_image(12, 12, -0.5F), constant_image(12, 12, 0.0F), {}, {NegativePixels::Allowed, 1});
  EXPECT_EQ(number(c, "psnr_srgb8"), kInfinity);
  EXPECT_DOUBLE_EQ(number(c, "l1"), 0.5);
}

// relMSE divides by the reference alone, as do those numbers of which a verdict is made.
TEST(MetricsNumbers, EveryMetricThatDoesNotDivideByTheReferenceIsSymmetricToTheBit) {
  const Image a = grey_image(40, 30, detail);
  const Image b = grey_image(40, 30, [](int x, int y) { return detail(y + 3, x); });
  const Comparison ab = compare(a, b, {}, {.all = true});
  const Comparison ba = compare(b, a, {}, {.all = true});
  for (const MetricInfo& metric : kMetrics) {
    if (metric.name.starts_with("relmse") || is_relative_to_reference(metric)) continue;
    EXPECT_EQ(number(ab, metric.name), number(ba, metric.name)) << metric.name;
  }
}

TEST(MetricsNumbers, MoreErrorIsWorseInEveryMetric) {
  const Image reference = grey_image(40, 30, detail);
  const auto noisy = [](float amplitude) {
    return grey_image(40, 30, [amplitude](int x, int y) {
      return detail(x, y) + amplitude * (0.5F - detail(3 * x + 1, 5 * y + 2));
    });
  };
  const CompareSettings settings{.negatives = NegativePixels::Allowed, .all = true};
  const Comparison little = compare(noisy(0.05F), reference, {}, settings);
  const Comparison much = compare(noisy(0.2F), reference, {}, settings);
  for (const MetricInfo& metric : kMetrics) {
    // A signed number may lie on either side, and these are 0 for errors that look like noise.
    static const std::set<std::string_view> kBeyondNoise{
        "local_bias",        "blocks_off", "window_error_8px", "window_error_16px",
        "window_error_64px", "line_error", "pattern_error"};
    if (metric.better == Better::NearZero || kBeyondNoise.contains(metric.name)) continue;
    if (!value_of(little, metric.name)) continue;
    const bool grows = number(much, metric.name) > number(little, metric.name);
    EXPECT_EQ(grows, metric.better == Better::Lower) << metric.name;
  }
}

// SSIM removes means before it compares structure: 2 % more light everywhere is invisible to it and clear to
// the others.
TEST(MetricsNumbers, TwoPercentMoreLightIsSeenByPsnrButHardlyBySsim) {
  const Image reference = grey_image(64, 64, [](int x, int y) { return 0.9F * detail(x, y); });
  const Image result = grey_image(64, 64, [](int x, int y) { return 1.02F * 0.9F * detail(x, y); });
  const Comparison c = compare(result, reference);
  EXPECT_GT(number(c, "ssim"), 0.999);
  EXPECT_LT(number(c, "psnr_srgb8"), 47.0);
  EXPECT_GT(number(c, "l1"), 0.005);
}

TEST(MetricsNumbers, AShiftByOnePixelIsSeenByEveryMetric) {
  const Comparison c =
      compare(grey_image(64, 64, [](int x, int y) { return detail(x + 1, y); }), grey_image(64, 64, detail));
  EXPECT_LT(number(c, "ssim"), 0.5);
  EXPECT_LT(number(c, "psnr_srgb8"), 20.0);
}

TEST(MetricsNumbers, ChannelsAreFoundByNameInAnyOrderAndOthersAreIgnored) {
  const Image reference = grey_image(12, 12, detail);
  Image result = orbs::image::make_image(12, 12, {"variance.R", "B", "G", "R", "A"});
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 12; ++x) {
      result.at(x, y, 0) = std::nanf("");
      result.at(x, y, 1) = reference.at(x, y, 2);
      result.at(x, y, 2) = reference.at(x, y, 1);
      result.at(x, y, 3) = reference.at(x, y, 0) + 0.3F;
    }
  const Comparison c = compare(result, reference);
  ASSERT_EQ(c.alignment.alignment, Alignment::Comparable) << c.alignment.reason;
  EXPECT_NEAR(number(c, "l1"), 0.1, 1e-7);
}

TEST(MetricsNumbers, NoNumberDependsOnTheThreads) {
  const Image a = grey_image(70, 90, detail);
  const Image b = grey_image(70, 90, [](int x, int y) { return detail(x, y + 2); });
  const Comparison one = compare(a, b, {}, {.threads = 1, .all = true});
  for (const int threads : {2, 3, 7}) {
    const Comparison other = compare(a, b, {}, {.threads = threads, .all = true});
    for (const MetricInfo& metric : kMetrics)
      EXPECT_EQ(value_of(other, metric.name), value_of(one, metric.name)) << metric.name;
  }
}
