#include "metrics/compare.h"
#include "metrics/flip_map.h"
#include "unit/metrics/images.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace {

using namespace orbs::metrics;
using namespace orbs::metrics_test;
using orbs::image::Image;

double flip_of(const Image& a, const Image& b, std::string_view metric = "flip") {
  return value_of(compare(a, b, {}, {.all = true}), metric).value();
}

// The definition taken literally for images without colour, in double: filters of two dimensions, no
// matrices (grey has X = Y = Z in units of white).
class GreyFlip {
 public:
  GreyFlip(const Image& a, const Image& b) : a_(a), b_(b) {}

  double at(int x, int y) const {
    const double colour = colour_error(lightness(a_, x, y), lightness(b_, x, y));
    const double feature = std::max(std::fabs(gradient(a_, x, y, 1) - gradient(b_, x, y, 1)),
                                    std::fabs(gradient(a_, x, y, 2) - gradient(b_, x, y, 2)));
    return std::pow(colour, 1 - std::sqrt(feature / std::sqrt(2)));
  }

 private:
  static double value(const Image& image, int x, int y) {
    return static_cast<double>(
        image.at(std::clamp(x, 0, image.width - 1), std::clamp(y, 0, image.height - 1), 1));
  }

  // Achromatic sensitivity a = 1, b = 0.0047; radius 10 at 67.02 pixels per degree.
  static double lightness(const Image& image, int x, int y) {
    double sum = 0;
    double weights = 0;
    for (int j = -10; j <= 10; ++j)
      for (int i = -10; i <= 10; ++i) {
        const double weight = std::exp(-kPi * kPi * (i * i + j * j) / (kPpd * kPpd) / 0.0047);
        sum += weight * value(image, x + i, y + j);
        weights += weight;
      }
    const double t = sum / weights;
    return 116 * (t > 216.0 / 24389 ? std::cbrt(t) : t * 841 / 108 + 4.0 / 29) - 16;
  }

  // Green (87.73, -86.18, 83.18) and blue (32.30, 79.19, -107.86) in CIELAB: after Hunt (87.73,
  // -75.61, 72.97) and (32.30, 25.58, -34.84), HyAB 55.43 + |(101.19, 107.81)| = 203.29.
  static double colour_error(double a, double b) {
    const double most = std::pow(203.29, 0.7);
    const double distance = std::pow(std::fabs(a - b), 0.7);
    if (distance < 0.4 * most) return 0.95 * distance / (0.4 * most);
    return 0.95 + 0.05 * (distance - 0.4 * most) / (0.6 * most);
  }

  // Length of the first or second derivative of a Gaussian of sigma 0.5 * 0.082 degrees, positive and
  // negative weights of sum 1.
  static double gradient(const Image& image, int x, int y, int order) {
    const double sigma = 0.5 * 0.082 * kPpd;
    std::array<double, 2> sums{};
    std::array<double, 2> positive{};
    std::array<double, 2> negative{};
    for (const bool is_weight_sum : {true, false})
      for (int j = -9; j <= 9; ++j)
        for (int i = -9; i <= 9; ++i)
          for (std::size_t axis = 0; axis < 2; ++axis) {
            const double d = axis == 0 ? i : j;
            const double g = std::exp(-(i * i + j * j) / (2 * sigma * sigma));
            const double weight = order == 1 ? -d * g : (d * d / (sigma * sigma) - 1) * g;
            auto& total = weight > 0 ? positive.at(axis) : negative.at(axis);
            if (is_weight_sum) {
              total += std::fabs(weight);
            } else {
              sums.at(axis) += weight / total * value(image, x + i, y + j);
            }
          }
    return std::hypot(sums[0], sums[1]);
  }

  static constexpr double kPi = 3.14159265358979;
  static constexpr double kPpd = 3840 * kPi / 180;
  const Image& a_;
  const Image& b_;
};

}  // namespace

TEST(Flip, OfTheSameImageIsNothing) {
  const Image image = grey_image(24, 20, detail);
  EXPECT_EQ(flip_of(image, image), 0.0);
  EXPECT_EQ(flip_of(image, image, "flip_hdr_fixed"), 0.0);
}

// Lightness 100 against 0, no features: 100^0.7 = 25.119 on a scale that ends at 203.29^0.7 = 41.276 and
// bends at 0.4 of it, 16.510: 0.95 + 0.05 (25.119 - 16.510) / 24.766.
TEST(Flip, OfWhiteAndBlackIsTheOneOfTheirLightness) {
  EXPECT_NEAR(flip_of(constant_image(16, 16, 1.0F), constant_image(16, 16, 0.0F)), 0.96738, 2e-5);
}

// The two colours that are the farthest apart on a screen are 1 by definition.
TEST(Flip, OfGreenAndBlueIsOne) {
  Image green = constant_image(16, 16, 0.0F);
  Image blue = green;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) green.at(x, y, 1) = blue.at(x, y, 2) = 1.0F;
  EXPECT_NEAR(flip_of(green, blue), 1.0, 1e-5);
}

TEST(Flip, IsTheLiteralDefinitionOnImagesWithoutColour) {
  const Image a = grey_image(30, 26, detail);
  const Image b = grey_image(30, 26, [](int x, int y) { return detail(x, y + (x > 12 ? 1 : 0)) * 0.9F; });
  const Comparison c = compare(a, b, {}, {.also = {"flip"}});
  const GreyFlip literal(a, b);
  double sum = 0;
  for (const auto& map : c.maps)
    if (map.info.name == "flip")
      for (int y = 0; y < 26; ++y)
        for (int x = 0; x < 30; ++x) {
          sum += literal.at(x, y);
          ASSERT_NEAR(static_cast<double>(map.image.at(x, y, 0)), literal.at(x, y), 2e-3) << x << ", " << y;
        }
  EXPECT_GT(sum, 1.0);
  EXPECT_NEAR(value_of(c, "flip").value(), sum / 780, 2e-4);
}

// Both are white on a screen; the lowest exposure of HDR-FLIP takes 2 to 0.85 and 20 to white.
TEST(Flip, OnlyHdrFlipSeesAWrongHighlight) {
  const Image reference = constant_image(16, 16, 20.0F);
  const Image result = constant_image(16, 16, 2.0F);
  EXPECT_EQ(flip_of(result, reference), 0.0);
  EXPECT_GT(flip_of(result, reference, "flip_hdr_fixed"), 0.1);
}

// The highest exposure takes 0.18 to 0.85.
TEST(Flip, HdrFlipSeesALeakIntoTheDark) {
  const Image reference = constant_image(16, 16, 0.0F);
  const Image result = constant_image(16, 16, 0.002F);
  EXPECT_GT(flip_of(result, reference, "flip_hdr_fixed"), 1.5 * flip_of(result, reference));
}
