#include "metrics/table.h"

#include "base/error.h"
#include "metrics/compare.h"
#include "unit/metrics/images.h"

#include <cmath>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace {

using namespace orbs::metrics;
using namespace orbs::metrics_test;
using orbs::image::Image;

const ErrorMap& map_named(const Comparison& comparison, std::string_view name) {
  for (const ErrorMap& map : comparison.maps)
    if (map.info.name == name) return map;
  throw std::runtime_error("no map " + std::string(name));
}

double mean_of(const Image& map) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const float value : map.pixels) {
    if (std::isnan(value)) continue;
    sum += static_cast<double>(value);
    ++count;
  }
  return sum / static_cast<double>(count);
}

}  // namespace

TEST(MetricsTable, EveryMetricHasItsOwnNameAUnitAndADefinition) {
  std::set<std::string_view> names;
  for (const MetricInfo& metric : kMetrics) {
    EXPECT_TRUE(names.insert(metric.name).second) << metric.name;
    EXPECT_FALSE(metric.unit.empty()) << metric.name;
    if (!metric.map.name.empty()) {
      EXPECT_FALSE(metric.map.definition.empty()) << metric.name;
      EXPECT_GT(metric.map.scale_maximum, 0.0F) << metric.name;
    }
    // What a reader needs to compute the number again: the domain, the clamp and what the mean is over.
    for (const char* word : {"linear Rec.709", "clamp", "masked"})
      EXPECT_NE(metric.definition.find(word), std::string_view::npos)
          << metric.name << " does not say: " << word;
  }
}

TEST(MetricsTable, AMetricIsFoundByNameAndAMisspeltOneIsAnswered) {
  EXPECT_EQ(find_metric("ssim").name, "ssim");
  try {
    find_metric("psnr_srgb");
    FAIL() << "no error";
  } catch (const orbs::InputError& e) {
    EXPECT_STREQ(
        e.what(),
        "there is no metric 'psnr_srgb' (did you mean 'psnr_srgb8'?); there are bias_squared, block_z_max, "
        "blocks_off, edge_blur, error_max, error_p95, error_p99, flip, flip_hdr_fixed, l1, l1_worst_tile, layer_error, layer_pixels, "
        "line_error, local_bias, mean_ratio_b, mean_ratio_g, mean_ratio_r, mse, noise_squared, pattern_error, "
        "pixel_z_max, pixels_beyond_3, psnr_linear, psnr_pu21, psnr_srgb8, relmse_eps01, relmse_eps01_trimmed, shared_noise, "
        "smallest_error_16px, smallest_error_64px, smape, ssim, ssim_jeri, stokes_error, stokes_scale_s1, stokes_scale_s2, stokes_scale_s3, stokes_turn, window_error_16px, "
        "window_error_64px, window_error_8px");
  }
}

TEST(MetricsTable, AComparisonHasEveryMetricAndEachMapOnce) {
  const Image image = grey_image(16, 16, detail);
  const Comparison c = compare(image, image, {}, {.all = true});
  ASSERT_EQ(c.measurements.size(), kMetrics.size());
  for (std::size_t i = 0; i < kMetrics.size(); ++i)
    EXPECT_EQ(c.measurements[i].metric->name, kMetrics[i].name);
  std::set<std::string_view> names;
  for (const ErrorMap& map : c.maps) {
    names.insert(map.info.name);
    EXPECT_EQ(map.image.width, 16);
    EXPECT_TRUE(map.image.channel_count() == 1 || map.image.channel_count() == 3);
  }
  EXPECT_EQ(names,
            (std::set<std::string_view>{"l1", "squared", "squared_srgb8", "ssim", "relmse_eps01", "smape",
                                        "flip", "flip_hdr_fixed", "squared_pu21", "ssim_jeri", "signed"}));
  EXPECT_EQ(c.maps.size(), names.size());
}

TEST(MetricsTable, WhatIsDearIsComputedOnlyWhereItIsAskedFor) {
  const Image image = grey_image(16, 16, detail);
  EXPECT_FALSE(value_of(compare(image, image), "flip"));
  EXPECT_TRUE(value_of(compare(image, image), "l1"));
  const Comparison asked = compare(image, image, {}, {.also = {"flip"}});
  EXPECT_TRUE(value_of(asked, "flip"));
  EXPECT_FALSE(value_of(asked, "psnr_pu21"));
  EXPECT_THROW(compare(image, image, {}, {.also = {"flop"}}), orbs::InputError);
}

// A map is the number before the mean: without a mask the mean of the map gives the number back.
TEST(MetricsTable, MapsAveragedGiveTheNumbers) {
  const Image a = grey_image(30, 20, detail);
  const Image b = grey_image(30, 20, [](int x, int y) { return detail(x, y + 1); });
  const Comparison c = compare(a, b);
  EXPECT_NEAR(mean_of(map_named(c, "l1").image), value_of(c, "l1").value(), 1e-7);
  EXPECT_NEAR(mean_of(map_named(c, "squared").image), value_of(c, "mse").value(), 1e-7);
  EXPECT_NEAR(1.0 - mean_of(map_named(c, "ssim").image), value_of(c, "ssim").value(), 1e-7);
  const double mse = mean_of(map_named(c, "squared_srgb8").image);
  EXPECT_NEAR(10.0 * std::log10(255.0 * 255.0 / mse), value_of(c, "psnr_srgb8").value(), 1e-6);
}

TEST(MetricsTable, TheSignedMapSaysWhichImageIsBrighter) {
  const Image reference = constant_image(4, 4, 0.5F);
  Image result = reference;
  result.at(1, 2, 0) = 0.75F;
  result.at(3, 0, 2) = 0.0F;
  const Comparison c = compare(result, reference);
  const ErrorMap& map = map_named(c, "signed");
  EXPECT_TRUE(map.info.is_signed);
  EXPECT_EQ(map.image.at(1, 2, 0), 0.25F);
  EXPECT_EQ(map.image.at(3, 0, 2), -0.5F);
  EXPECT_EQ(map.image.at(0, 0, 1), 0.0F);
}

TEST(MetricsTable, TheSsimMapHasNoValueWhereNoWindowFits) {
  const Image image = grey_image(12, 13, detail);
  const Comparison c = compare(image, image);
  const ErrorMap& map = map_named(c, "ssim");
  for (int y = 0; y < 13; ++y)
    for (int x = 0; x < 12; ++x) {
      const bool fits = x >= 5 && x < 7 && y >= 5 && y < 8;
      EXPECT_EQ(std::isnan(map.image.at(x, y, 0)), !fits) << x << ", " << y;
    }
}
