// Images whose means are nearer to the reference than their noise allows, and right ones.
#include "metrics/near_areas.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

using namespace orbs;

namespace {

constexpr int kSide = 128;
constexpr double kFalseAlarm = 1e-7;

image::Image blank() {
  return image::make_image(kSide, kSide, {"R", "G", "B", "variance.R", "variance.G", "variance.B"});
}

// Slopes, and a board with sharp edges.
image::Image computed_reference() {
  auto image = image::make_image(kSide, kSide, {"R", "G", "B"});
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        image.at(x, y, c) =
            (x > 40 && x < 81 && y > 30 && y < 99 ? 0.2F : 0.6F) + 0.002F * static_cast<float>(x);
  return image;
}

// Exponential noise, as skewed as that of light: with `rare` only one of so many samples carries any.
image::Image rendered(const image::Image& right, double factor, int rare, std::mt19937& random) {
  constexpr int kSamples = 16;
  std::exponential_distribution<double> light(1);
  std::uniform_real_distribution<double> chance(0, 1);
  auto image = blank();
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      double sum = 0;
      double squares = 0;
      for (int i = 0; i < kSamples; ++i) {
        const double sample = chance(random) * rare < 1 ? rare * light(random) : 0;
        sum += sample;
        squares += sample * sample;
      }
      const double mean = sum / kSamples;
      const double variance = (squares / kSamples - mean * mean) / (kSamples - 1);
      for (std::size_t c = 0; c < 3; ++c) {
        const double value = factor * static_cast<double>(right.at(x, y, c));
        image.at(x, y, c) = static_cast<float>(value * mean);
        image.at(x, y, 3 + c) = static_cast<float>(value * value * variance);
      }
    }
  return image;
}

double blurred(const image::Image& image, int x, int y, std::size_t c) {
  constexpr int kReach = 3;
  double sum = 0;
  for (int v = y - kReach; v <= y + kReach; ++v)
    for (int u = x - kReach; u <= x + kReach; ++u)
      sum += static_cast<double>(image.at(std::clamp(u, 0, kSide - 1), std::clamp(v, 0, kSide - 1), c));
  return sum;
}

image::Image corrected(const image::Image& own, const image::Image& reference) {
  auto image = own;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        image.at(x, y, c) *= static_cast<float>(blurred(reference, x, y, c) / blurred(own, x, y, c));
  return image;
}

auto found(const image::Image& result, const image::Image& reference) {
  return metrics::near_areas(metrics::pair_samples(result, reference), kFalseAlarm);
}

}  // namespace

TEST(NearAreas, AnImageThatWasCorrectedByTheReferenceIsFound) {
  const auto reference = computed_reference();
  std::mt19937 random(1);
  const auto own = rendered(reference, 0.94, 1, random);
  const auto areas = found(corrected(own, reference), reference);
  ASSERT_TRUE(areas);
  EXPECT_LT(areas->share, 0.2);
}

TEST(NearAreas, RightImagesAreNot) {
  const auto reference = computed_reference();
  std::mt19937 random(2);
  for (int seed = 0; seed < 10; ++seed)
    for (const int rare : {1, 20, 1000}) {
      const auto areas = found(rendered(reference, 1, rare, random), reference);
      EXPECT_FALSE(areas) << rare << ": " << areas->share;
    }
}

// Filters differ at edges, and the difference has no mean.
TEST(NearAreas, AnotherFilterIsNot) {
  const auto reference = computed_reference();
  auto soft = reference;
  for (int y = 0; y < kSide; ++y)
    for (int x = 1; x + 1 < kSide; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        soft.at(x, y, c) = 0.25F * reference.at(x - 1, y, c) + 0.5F * reference.at(x, y, c) +
                           0.25F * reference.at(x + 1, y, c);
  std::mt19937 random(3);
  for (int seed = 0; seed < 10; ++seed) EXPECT_FALSE(found(rendered(soft, 1, 1, random), reference));
}

TEST(NearAreas, OverstatedVariancesDoNotExplainIt) {
  const auto reference = computed_reference();
  std::mt19937 random(4);
  auto image = rendered(reference, 1, 1, random);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      for (std::size_t c = 3; c < 6; ++c) image.at(x, y, c) *= 16;
  EXPECT_FALSE(found(image, reference));
}
