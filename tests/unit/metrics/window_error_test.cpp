// Windows of a grey image with a part that is off, with and without noise.
#include "metrics/window_error.h"

#include "images.h"

#include <random>

#include <gtest/gtest.h>

using namespace orbs;
using metrics_test::constant_image;
using metrics_test::grey_image;

namespace {

image::Image with_variance(const image::Image& colours, float variance) {
  auto image = image::make_image(colours.width, colours.height,
                                 {"R", "G", "B", "variance.R", "variance.G", "variance.B"});
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        image.at(x, y, c) = colours.at(x, y, c);
        image.at(x, y, c + 3) = variance;
      }
  return image;
}

void multiply(image::Image& image, const Rectangle& where, float factor) {
  for (int y = where.y0; y < where.y1; ++y)
    for (int x = where.x0; x < where.x1; ++x)
      for (std::size_t c = 0; c < 3; ++c) image.at(x, y, c) *= factor;
}

void add_noise(image::Image& image, float deviation, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<float> noise(0, deviation);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) image.at(x, y, c) += noise(random);
}

metrics::WindowErrors errors_of(const image::Image& result, const image::Image& reference) {
  return metrics::window_errors(metrics::pair_samples(result, reference));
}

// Grey 0.5, all of which comes in hits: one of them adds `hit` to its pixel, and its square to the variance.
image::Image of_rare_light(int side_px, float hit, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::poisson_distribution<int> hits(0.5 / static_cast<double>(hit));
  auto image = with_variance(constant_image(side_px, side_px, 0), 0);
  for (int y = 0; y < side_px; ++y)
    for (int x = 0; x < side_px; ++x) {
      const auto count = static_cast<float>(hits(random));
      for (std::size_t c = 0; c < 3; ++c) {
        image.at(x, y, c) = count * hit;
        image.at(x, y, c + 3) = count * hit * hit;
      }
    }
  return image;
}

constexpr std::size_t k8 = 0;
constexpr std::size_t k16 = 1;
constexpr std::size_t k64 = 2;

}  // namespace

// Wherever it lies: (37, 21) is on no grid of blocks.
TEST(WindowError, FindsAPatchWhereItLies) {
  auto result = with_variance(constant_image(128, 128, 0.5F), 0);
  multiply(result, {37, 21, 53, 37}, 1.05F);
  const auto errors = errors_of(result, with_variance(constant_image(128, 128, 0.5F), 0));
  EXPECT_NEAR(errors[k8]->value, 0.05, 1e-4);
  EXPECT_GT(errors[k16]->value, 0.05 * 0.87);
  EXPECT_LE(errors[k16]->value, 0.0501);
  EXPECT_NEAR(errors[k16]->where.x0, 37, 1);
  EXPECT_NEAR(errors[k16]->where.y0, 21, 1);
  EXPECT_NEAR(errors[k64]->value, 0.05 / 16, 1e-4);
}

// A leak into the dark is measured by the image over 8 px, and by a tenth of it over 16 px.
TEST(WindowError, ALeakIsMeasuredByTheImage) {
  const auto half_dark =
      with_variance(grey_image(128, 128, [](int x, int) { return x < 64 ? 0.0F : 1.0F; }), 0);
  auto result = half_dark;
  for (int y = 64; y < 72; ++y)
    for (int x = 16; x < 24; ++x) result.at(x, y, 1) = 0.05F;
  const auto errors = errors_of(result, half_dark);
  EXPECT_NEAR(errors[k8]->value, 0.1, 1e-4);
  EXPECT_NEAR(errors[k16]->value, 0.05 / 4 / 0.05, 1e-3);
}

TEST(WindowError, AnEdgeMayLieATwentiethOfAPixelAway) {
  const auto edge_at = [](double place) {
    return with_variance(grey_image(64, 64,
                                    [place](int x, int) {
                                      return 0.1F +
                                             50 * static_cast<float>(std::clamp(x + 1 - place, 0.0, 1.0));
                                    }),
                         0);
  };
  const auto errors = errors_of(edge_at(32.05), edge_at(32));
  EXPECT_NEAR(errors[k8]->value, 0, 1e-4);
  EXPECT_GT(errors_of(edge_at(32.3), edge_at(32))[k8]->value, 0.02);
}

// 300 right images: variances stated, scatter of neighbours.
TEST(WindowError, NoiseIsNone) {
  const auto reference = with_variance(constant_image(64, 64, 0.5F), 0);
  for (std::uint32_t seed = 0; seed < 150; ++seed) {
    auto result = constant_image(64, 64, 0.5F);
    add_noise(result, 0.1F, seed);
    for (const auto& image : {with_variance(result, 0.01F), result})
      for (const auto& error : errors_of(image, reference)) EXPECT_EQ(error->value, 0) << seed;
  }
}

TEST(WindowError, IsFoundWithoutVariances) {
  auto result = constant_image(128, 128, 0.5F);
  multiply(result, {32, 32, 48, 48}, 1.1F);
  add_noise(result, 0.01F, 1);
  const auto errors = errors_of(result, constant_image(128, 128, 0.5F));
  EXPECT_GT(errors[k16]->value, 0.08);
  EXPECT_LT(errors[k16]->value, 0.1);
}

TEST(WindowError, AFireflyIsNone) {
  auto result = constant_image(64, 64, 0.25F);
  result.at(20, 20, 0) = 1000;
  for (const auto& error : errors_of(result, constant_image(64, 64, 0.25F))) EXPECT_EQ(error->value, 0);
}

TEST(WindowError, OfABlackReferenceOrASmallImageThereIsNone) {
  EXPECT_FALSE(errors_of(constant_image(64, 64, 0.25F), constant_image(64, 64, 0))[k8]);
  const auto errors = errors_of(constant_image(12, 12, 0.25F), constant_image(12, 12, 0.25F));
  EXPECT_TRUE(errors[k8]);
  EXPECT_FALSE(errors[k16]);
}

TEST(WindowError, MaskedPixelsDoNotCount) {
  auto result = constant_image(64, 64, 0.25F);
  multiply(result, {16, 16, 32, 32}, 3);
  const auto errors = metrics::window_errors(
      metrics::pair_samples(result, constant_image(64, 64, 0.25F), {{{16, 16, 32, 32}}, {}}));
  for (const auto& error : errors) EXPECT_EQ(error->value, 0);
}

// A window is expected to see 1.1 to 8 hits, so that a few to most windows of the image see none and are
// black without noise.
TEST(WindowError, LightThatNoSampleHasFoundIsNone) {
  const auto reference = with_variance(constant_image(64, 64, 0.5F), 0);
  for (const float hit : {4.0F, 10.0F, 30.0F})
    for (std::uint32_t seed = 0; seed < 50; ++seed)
      for (const auto& error : errors_of(of_rare_light(64, hit, seed), reference))
        EXPECT_EQ(error->value, 0) << hit << ' ' << seed;
}

// The light of the others comes in hits of 0.01, of which the black window lacks 3200.
TEST(WindowError, ABlackWindowThatLacksManyHitsIsOne) {
  auto result = of_rare_light(64, 0.01F, 1);
  for (int y = 16; y < 24; ++y)
    for (int x = 24; x < 32; ++x)
      for (std::size_t c = 0; c < 6; ++c) result.at(x, y, c) = 0;
  EXPECT_GT(errors_of(result, with_variance(constant_image(64, 64, 0.5F), 0))[k8]->value, 0.9);
}

// Fireflies elsewhere do not excuse a window whose pixels all have noise.
TEST(WindowError, AWindowThatKnowsItsNoiseIsNotExcused) {
  auto result = constant_image(64, 64, 0.5F);
  add_noise(result, 0.01F, 1);
  result = with_variance(result, 0.0001F);
  for (int i = 0; i < 5; ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      result.at(50, 10 * i, c) = 20;
      result.at(50, 10 * i, c + 3) = 400;
    }
  multiply(result, {16, 16, 32, 32}, 0.9F);
  EXPECT_GT(errors_of(result, with_variance(constant_image(64, 64, 0.5F), 0))[k16]->value, 0.09);
}
