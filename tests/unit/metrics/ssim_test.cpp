#include "metrics/ssim.h"

#include "image/colour.h"
#include "metrics/compare.h"
#include "unit/metrics/images.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace {

using namespace orbs::metrics;
using namespace orbs::metrics_test;
using orbs::image::Image;
using orbs::image::srgb_encode;

constexpr double kC1 = 1e-4;
constexpr double kC2 = 9e-4;

double ssim_of(const Image& a, const Image& b) { return value_of(compare(a, b), "ssim").value(); }

// The definition taken literally: a 2-D window of 121 weights, means first, then centred second moments.
double literal_ssim(const Image& a, const Image& b) {
  const auto luma = [](const Image& image, int x, int y) {
    return orbs::image::luminance(srgb_encode(image.at(x, y, 0)), srgb_encode(image.at(x, y, 1)),
                                  srgb_encode(image.at(x, y, 2)));
  };
  std::array<std::array<double, 11>, 11> window{};
  double weight_sum = 0.0;
  for (int j = 0; j < 11; ++j)
    for (int i = 0; i < 11; ++i)
      weight_sum += window[j][i] = std::exp(-((i - 5) * (i - 5) + (j - 5) * (j - 5)) / (2.0 * 1.5 * 1.5));
  double sum = 0.0;
  int count = 0;
  for (int top = 0; top + 11 <= a.height; ++top)
    for (int left = 0; left + 11 <= a.width; ++left, ++count) {
      const auto mean = [&](auto value) {
        double total = 0.0;
        for (int j = 0; j < 11; ++j)
          for (int i = 0; i < 11; ++i) total += window[j][i] / weight_sum * value(left + i, top + j);
        return total;
      };
      const double mx = mean([&](int x, int y) { return luma(a, x, y); });
      const double my = mean([&](int x, int y) { return luma(b, x, y); });
      const double vx = mean([&](int x, int y) { return std::pow(luma(a, x, y) - mx, 2); });
      const double vy = mean([&](int x, int y) { return std::pow(luma(b, x, y) - my, 2); });
      const double vxy = mean([&](int x, int y) { return (luma(a, x, y) - mx) * (luma(b, x, y) - my); });
      sum += (2 * mx * my + kC1) * (2 * vxy + kC2) / ((mx * mx + my * my + kC1) * (vx + vy + kC2));
    }
  return sum / count;
}

// Sum of the normalised 1-D window's centre weight: 1 / (1 + 2 sum_k exp(-k^2 / 4.5)).
double centre_weight() {
  double sum = 1.0;
  for (int k = 1; k <= 5; ++k) sum += 2.0 * std::exp(-k * k / 4.5);
  return 1.0 / sum;
}

}  // namespace

TEST(MetricsSsim, TheWindowHasSumOneAndFallsOffAsAGaussian) {
  const auto weights = ssim::window_weights();
  double sum = weights[0];
  for (std::size_t k = 1; k < weights.size(); ++k) sum += 2.0 * weights[k];
  EXPECT_NEAR(sum, 1.0, 1e-15);
  EXPECT_NEAR(weights[3] / weights[0], std::exp(-2.0), 1e-15);  // 3 px are two sigma: exp(-9 / 4.5)
  EXPECT_NEAR(weights[0], centre_weight(), 1e-15);
}

// No variance anywhere: only the luminance term is left, (2xy + C1) / (x^2 + y^2 + C1).
TEST(MetricsSsim, ConstantImagesHaveTheLuminanceTermAlone) {
  for (const auto& [x, y] : {std::pair{0.6, 0.5}, std::pair{0.02, 0.9}, std::pair{0.0, 1.0}}) {
    const double expected = (2 * x * y + kC1) / (x * x + y * y + kC1);
    const double found =
        ssim_of(displayed_grey(20, 15, static_cast<float>(x)), displayed_grey(20, 15, static_cast<float>(y)));
    EXPECT_NEAR(found, expected, 1e-6) << x << ' ' << y;
  }
}

// One white pixel on black in the only window of an 11 x 11 image, against black. With the window's centre
// weight w: mean w, variance w - w^2, covariance 0: SSIM = C1 C2 / ((w^2 + C1) (w - w^2 + C2)).
TEST(MetricsSsim, AnImpulseInTheOnlyWindowHasItsClosedForm) {
  const Image black = constant_image(11, 11, 0.0F);
  const Image impulse = grey_image(11, 11, [](int x, int y) { return x == 5 && y == 5 ? 1.0F : 0.0F; });
  const double w = centre_weight() * centre_weight();
  const double expected = kC1 * kC2 / ((w * w + kC1) * (w - w * w + kC2));
  EXPECT_NEAR(ssim_of(impulse, black) / expected, 1.0, 1e-5);
}

// White weighs w there, so the covariance of both images is w^2 below theirs when the impulses are at
// different places: means w and v, covariance -w v, variances w - w^2 and v - v^2.
TEST(MetricsSsim, TwoImpulsesAtDifferentPlacesHaveNegativeCovariance) {
  const auto impulse = [](int column) {
    return grey_image(11, 11, [column](int x, int y) { return x == column && y == 5 ? 1.0F : 0.0F; });
  };
  const double w = centre_weight() * centre_weight();
  const double v = w * std::exp(-4 / 4.5);  // two pixels beside the centre
  const double expected =
      (2 * w * v + kC1) * (-2 * w * v + kC2) / ((w * w + v * v + kC1) * (w - w * w + v - v * v + kC2));
  EXPECT_NEAR(ssim_of(impulse(5), impulse(7)), expected, 1e-6);
}

TEST(MetricsSsim, TheSeparableFilterAgreesWithTheLiteralDefinition) {
  const Image a = grey_image(19, 14, detail);
  Image b = grey_image(19, 14, [](int x, int y) { return 0.8F * detail(x, y) + 0.1F * detail(y, x); });
  b.at(7, 7, 0) = 0.9F;  // colours differ too: the luma weights matter
  b.at(9, 6, 2) = 0.1F;
  EXPECT_NEAR(ssim_of(a, b), literal_ssim(a, b), 1e-10);
}

TEST(MetricsSsim, TheClampComesBeforeTheEncoding) {
  const Image a = grey_image(16, 16, [](int x, int y) { return (x + y) % 3 == 0 ? 1.0F : 0.2F; });
  const Image b = grey_image(16, 16, [](int x, int y) { return (x + y) % 3 == 0 ? 50.0F : 0.2F; });
  EXPECT_EQ(ssim_of(a, b), 1.0);
}

TEST(MetricsSsim, AnImageSmallerThanTheWindowHasNoValue) {
  for (const auto& [width, height] : {std::pair{10, 30}, std::pair{30, 10}, std::pair{1, 1}}) {
    const Image image = grey_image(width, height, detail);
    const Comparison c = compare(image, image);
    EXPECT_EQ(c.alignment.alignment, Alignment::Comparable);
    EXPECT_FALSE(value_of(c, "ssim").has_value()) << width << " x " << height;
    EXPECT_TRUE(value_of(c, "l1").has_value());
  }
  const Image smallest = grey_image(11, 11, detail);
  EXPECT_EQ(value_of(compare(smallest, smallest), "ssim"), 1.0);
}
