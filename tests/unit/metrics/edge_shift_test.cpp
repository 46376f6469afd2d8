// Shifts of images with few edges: found with their size and side, and not where a filter or noise differs.
#include "metrics/edge_shift.h"

#include "metrics/image_pair.h"
#include "metrics/patterns.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

using namespace orbs;

namespace {

constexpr int kSide = 40;
constexpr double kMost = 0.3;  // px

using Light = std::function<double(double x, double y)>;

// A ball before a sky that is little brighter, darker towards its rim: nothing else has an edge.
double ball(double x, double y) {
  const double r = std::hypot(x - 20.2, y - 19.7) / 14;
  return r > 1 ? 1 : 0.93 - 0.15 * (1 - std::sqrt(1 - r * r));
}

// Light on a wall about a lamp out of sight, and a dark board.
double dark_room(double x, double y) {
  const bool is_board = x > 9.4 && x < 17.8 && y > 22.3 && y < 31.6;
  return is_board ? 0.002 : 0.05 / (1 + 0.01 * (x * x + y * y));
}

// Means over squares that are `width` px wide, seen from `shift` px to the right.
image::Image image_of(const Light& light, double shift_x, double shift_y, double width = 1) {
  constexpr int kPlaces = 12;
  auto image = image::make_image(kSide, kSide, {"R", "G", "B"});
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      double sum = 0;
      for (int i = 0; i < kPlaces; ++i)
        for (int j = 0; j < kPlaces; ++j)
          sum += light(x + 0.5 + width * ((i + 0.5) / kPlaces - 0.5) + shift_x,
                       y + 0.5 + width * ((j + 0.5) / kPlaces - 0.5) + shift_y);
      for (std::size_t c = 0; c < 3; ++c) image.at(x, y, c) = static_cast<float>(sum / (kPlaces * kPlaces));
    }
  return image;
}

image::Image with_noise(const image::Image& image, double relative, std::mt19937& random) {
  std::normal_distribution<double> normal(0, 1);
  auto noisy = image::make_image(kSide, kSide, {"R", "G", "B", "variance.R", "variance.G", "variance.B"});
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const double deviation = relative * static_cast<double>(image.at(x, y, 0));
      const double off = deviation * normal(random);
      for (std::size_t c = 0; c < 3; ++c) {
        noisy.at(x, y, c) = image.at(x, y, c) + static_cast<float>(off);
        noisy.at(x, y, 3 + c) = static_cast<float>(deviation * deviation);
      }
    }
  return noisy;
}

constexpr double kFalseAlarm = 1e-6;

metrics::EdgeShift shift_of(const image::Image& result, const image::Image& reference) {
  const auto noise = image::channel_index(result, "variance.R") < 0 ? metrics::ResultNoise::NoiseFree
                                                                    : metrics::ResultNoise::AsTheImageSays;
  return metrics::edge_shift(metrics::pair_samples(result, reference, {}, noise), kFalseAlarm);
}

bool is_beyond(const Interval& shift) { return shift.low > kMost || shift.high < -kMost; }

}  // namespace

TEST(EdgeShift, HalfAPixelIsFoundWithItsSide) {
  for (const Light& light : {Light(ball), Light(dark_room)}) {
    const auto reference = image_of(light, 0, 0);
    for (const double step : {-0.5, 0.5}) {
      const auto in_x = shift_of(image_of(light, step, 0), reference);
      EXPECT_TRUE(is_beyond(in_x.px[0])) << in_x.px[0].low << " " << in_x.px[0].high;
      EXPECT_GT(in_x.px[0].value * step, 0);
      EXPECT_FALSE(is_beyond(in_x.px[1]));
      const auto in_y = shift_of(image_of(light, 0, step), reference);
      EXPECT_TRUE(is_beyond(in_y.px[1])) << in_y.px[1].low << " " << in_y.px[1].high;
      EXPECT_FALSE(is_beyond(in_y.px[0]));
    }
  }
}

// The gate of patterns fails above an excess of 1.
TEST(EdgeShift, HalfAPixelIsBeyondTheGateOfPatterns) {
  constexpr double kOfAllPatterns = 1e-5;
  for (const Light& light : {Light(ball), Light(dark_room)}) {
    const auto samples = metrics::pair_samples(image_of(light, 0.5, 0), image_of(light, 0, 0), {},
                                               metrics::ResultNoise::NoiseFree);
    const auto findings = metrics::find_patterns(samples, kOfAllPatterns);
    const auto shift = std::find_if(findings.begin(), findings.end(), [](const auto& one) {
      return one.pattern->more == "shifted to the left";
    });
    ASSERT_NE(shift, findings.end());
    EXPECT_GT(shift->excess, 1);
    EXPECT_NE(metrics::describe(*shift).find("shifted to the left by"), std::string::npos);
  }
}

TEST(EdgeShift, ItIsFoundInNoise) {
  const auto reference = image_of(dark_room, 0, 0);
  std::mt19937 random(5);
  const auto noisy = shift_of(with_noise(image_of(dark_room, 0.5, 0), 0.03, random), reference);
  EXPECT_TRUE(is_beyond(noisy.px[0])) << noisy.px[0].low << " " << noisy.px[0].high;
}

TEST(EdgeShift, ATenthOfAPixelIsNotBeyondTheLimit) {
  for (const Light& light : {Light(ball), Light(dark_room)})
    EXPECT_FALSE(is_beyond(shift_of(image_of(light, 0.1, 0), image_of(light, 0, 0)).px[0]));
}

TEST(EdgeShift, AWiderFilterIsNone) {
  for (const Light& light : {Light(ball), Light(dark_room)}) {
    const auto wide = shift_of(image_of(light, 0, 0, 2), image_of(light, 0, 0));
    for (const auto& shift : wide.px) EXPECT_LT(std::max(std::fabs(shift.low), std::fabs(shift.high)), 0.3);
  }
}

TEST(EdgeShift, OtherLightIsNone) {
  const auto reference = image_of(dark_room, 0, 0);
  const Light brighter = [](double x, double y) { return dark_room(x, y) * (1 + 0.002 * x); };
  for (const auto& shift : shift_of(image_of(brighter, 0, 0), reference).px) EXPECT_FALSE(is_beyond(shift));
}

TEST(EdgeShift, NoiseIsNone) {
  std::mt19937 random(2);
  for (const Light& light : {Light(ball), Light(dark_room)}) {
    const auto reference = image_of(light, 0, 0);
    for (int seed = 0; seed < 40; ++seed)
      for (const double noise : {0.003, 0.03, 0.3})
        for (const auto& shift : shift_of(with_noise(reference, noise, random), reference).px)
          EXPECT_FALSE(is_beyond(shift)) << noise;
  }
}
