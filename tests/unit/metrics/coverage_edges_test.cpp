// The coverage at outlines: the covered share with the noise of its samples, and what is not the share.
#include "metrics/coverage_edges.h"

#include "metrics/image_pair.h"
#include "metrics/surface_layers.h"

#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

using namespace orbs;

namespace {

constexpr int kWidth = 24;
constexpr int kHeight = 16;

using Coverage = std::function<double(int x, int y)>;

image::Image image_of(const Coverage& coverage) {
  auto image = image::make_image(kWidth, kHeight, {"R", "G", "B", "coverage.A"});
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) image.at(x, y, 3) = static_cast<float>(coverage(x, y));
  return image;
}

// A disk, somewhat beside the middle.
bool is_inside(double x, double y, double grown = 0) { return std::hypot(x - 11.3, y - 8.2) < 5.4 + grown; }

// The share of each pixel under a box filter.
Coverage share(double shift_x, double grown = 0) {
  return [=](int x, int y) {
    constexpr int kSide = 32;
    int inside = 0;
    for (int i = 0; i < kSide; ++i)
      for (int j = 0; j < kSide; ++j)
        inside += is_inside(x + (i + 0.5) / kSide - shift_x, y + (j + 0.5) / kSide, grown) ? 1 : 0;
    return inside / static_cast<double>(kSide * kSide);
  };
}

// Under a tent that is two pixels wide.
double tent_share(int x, int y) {
  constexpr int kSide = 32;
  double sum = 0;
  double weights = 0;
  for (int i = -kSide; i < kSide; ++i)
    for (int j = -kSide; j < kSide; ++j) {
      const double u = (i + 0.5) / kSide;
      const double v = (j + 0.5) / kSide;
      const double weight = (1 - std::fabs(u)) * (1 - std::fabs(v));
      weights += weight;
      if (is_inside(x + 0.5 + u, y + 0.5 + v)) sum += weight;
    }
  return sum / weights;
}

double binary(int x, int y) { return is_inside(x + 0.5, y + 0.5) ? 1 : 0; }

Coverage sampled(int samples, std::mt19937& random) {
  return [samples, &random](int x, int y) {
    std::uniform_real_distribution<double> in_pixel(0, 1);
    int inside = 0;
    for (int i = 0; i < samples; ++i) {
      const double u = in_pixel(random);
      inside += is_inside(x + u, y + in_pixel(random)) ? 1 : 0;
    }
    return inside / static_cast<double>(samples);
  };
}

metrics::MetricResult error(const Coverage& result, int spp = 16) {
  static const auto reference = image_of(share(0));
  return metrics::compute_layer_error(
      metrics::make_image_pair(image_of(result), reference, {}, {.looks = 12, .spp = spp}));
}

}  // namespace

TEST(CoverageEdges, ZeroAndOneAloneAreNoShare) {
  const auto found = error(binary);
  EXPECT_GT(*found.value, 0.001);
  EXPECT_NE(found.what.find("off at edges"), std::string::npos) << found.what;
}

TEST(CoverageEdges, HalfAPixelOfShiftOrGrowthIsFound) {
  for (const double step : {-0.5, 0.5}) {
    EXPECT_GT(*error(share(step)).value, 0.001) << step;
    EXPECT_GT(*error(share(0, step)).value, 0.001) << step;
  }
}

TEST(CoverageEdges, TheNoiseOfSamplesIsRight) {
  std::mt19937 random(3);
  for (int seed = 0; seed < 40; ++seed) {
    EXPECT_EQ(*error(sampled(8, random)).value, 0) << seed;
    EXPECT_EQ(*error(sampled(32, random)).value, 0) << seed;
    EXPECT_EQ(*error(sampled(1, random), 2).value, 0) << seed;  // of two renders of one sample each
  }
}

TEST(CoverageEdges, AnAntialiasingThatDiffersALittleIsRight) {
  EXPECT_EQ(*error(share(0.15)).value, 0);
  EXPECT_EQ(*error(tent_share).value, 0);
}
