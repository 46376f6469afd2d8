// The rendered references of ambient occlusion against their closed forms, pixel for pixel: what the built-in
// tracer made is judged by nothing that it computes. Those of i1-wall and i1-sphere are computed anyway.
#include "image/image_io.h"

#include <cmath>
#include <filesystem>
#include <numbers>

#include <gtest/gtest.h>

using namespace orbs;

namespace {

constexpr int kSide = 128;

// The cameras look down from 100 m at x = 1 with a vertical field of view of 1.2 degrees.
double distance_to_wall(double column) {
  return 1 + (2 * column / kSide - 1) * 100 * std::tan(0.6 * std::numbers::pi / 180);
}

// The mean over a column, by Simpson's rule: the second derivative changes little within 16 mm.
template <typename F>
double column_mean(int x, const F& open_share) {
  const auto at = [&](double part) { return open_share(distance_to_wall(x + part)); };
  return (at(0) + 4 * at(0.5) + at(1)) / 6;
}

template <typename F>
void expect_closed_form(const std::string& name, const F& open_share) {
  const auto image = image::read_image(std::filesystem::path(ORBS_SOURCE_DIR) /
                                       "data/references/integrators" / (name + ".exr"));
  ASSERT_EQ(image.width, kSide);
  const auto red = static_cast<std::size_t>(image::channel_index(image, "R"));
  const auto variance = static_cast<std::size_t>(image::channel_index(image, "variance.R"));
  double all_squares = 0;
  double all_variances = 0;
  // The camera sees the wall itself in the first three columns of i1-distance.
  for (int x = 4; x < kSide; ++x) {
    const double expected = column_mean(x, open_share);
    double sum = 0;
    double variances = 0;
    for (int y = 0; y < kSide; ++y) {
      const double deviation = static_cast<double>(image.at(x, y, red)) - expected;
      // References keep 9 bits of a colour: an even rounding by up to 2^-9 of it.
      const double rounding = std::pow(expected * 0x1p-9, 2) / 3;
      const double own = static_cast<double>(image.at(x, y, variance)) + rounding;
      sum += deviation;
      variances += own;
      all_squares += deviation * deviation;
    }
    all_variances += variances;
    EXPECT_LT(std::abs(sum), 5 * std::sqrt(variances)) << name << " column " << x;
  }
  // 16000 pixels have deviations as large as their variances say, and no larger.
  EXPECT_NEAR(all_squares / all_variances, 1, 0.1) << name;
}

}  // namespace

TEST(OcclusionReferences, UniformWeightHasItsClosedFormInEachPixel) {
  expect_closed_form("i1-wall-uniform", [](double d) { return 1 - std::atan(1 / d) / std::numbers::pi; });
}

TEST(OcclusionReferences, RaysOfTwoMetresHaveTheirClosedFormInEachPixel) {
  expect_closed_form("i1-distance", [](double d) {
    const double q = d / 2;
    return q >= 1 ? 1 : 1 - (std::acos(q) - q * std::sqrt(1 - q * q)) / std::numbers::pi;
  });
}
