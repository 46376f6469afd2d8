// Stripes whose edges are filtered, halved in resolution, or only noisy.
#include "metrics/edge_blur.h"

#include "metrics/image_pair.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

using namespace orbs;

namespace {

constexpr int kSide_px = 66;

image::Image stripes() {
  auto image = image::make_image(kSide_px, kSide_px, {"R", "G", "B"});
  for (int y = 0; y < kSide_px; ++y)
    for (int x = 0; x < kSide_px; ++x)
      for (std::size_t c = 0; c < 3; ++c) image.at(x, y, c) = (x / 5) % 2 == 0 ? 0.2F : 0.6F;
  return image;
}

// [1 2 1] / 4 in x; y has no edges.
image::Image filtered(const image::Image& image) {
  auto out = image;
  for (int y = 0; y < kSide_px; ++y)
    for (int x = 1; x + 1 < kSide_px; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        out.at(x, y, c) = (image.at(x - 1, y, c) + 2 * image.at(x, y, c) + image.at(x + 1, y, c)) / 4;
  return out;
}

// Means of 2 px in x.
image::Image halved(const image::Image& image) {
  auto out = image;
  for (int y = 0; y < kSide_px; ++y)
    for (int x = 0; x < kSide_px; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        out.at(x, y, c) = (image.at(x - x % 2, y, c) + image.at(x - x % 2 + 1, y, c)) / 2;
  return out;
}

image::Image noisy(const image::Image& image, float deviation, std::mt19937& random) {
  std::normal_distribution<float> noise(0, deviation);
  auto out = image;
  for (auto& value : out.pixels) value += noise(random);
  return out;
}

// Noise of 4 %, and in every tenth pixel as large as the image; the image knows both.
image::Image noisy_reference(std::mt19937& random) {
  const auto right = stripes();
  auto out = image::make_image(kSide_px, kSide_px, {"R", "G", "B", "variance.R", "variance.G", "variance.B"});
  for (int y = 0; y < kSide_px; ++y)
    for (int x = 0; x < kSide_px; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        const float deviation = (x + 3 * y) % 10 == 0 ? 0.4F : 0.016F;
        out.at(x, y, c) = right.at(x, y, c) + std::normal_distribution<float>(0, deviation)(random);
        out.at(x, y, c + 3) = deviation * deviation;
      }
  return out;
}

}  // namespace

TEST(EdgeBlur, OfTheFilterItselfIsOne) {
  const auto blur = metrics::edge_blur(metrics::pair_samples(filtered(stripes()), stripes()));
  ASSERT_TRUE(blur);
  EXPECT_NEAR(blur->value, 1, 1e-5);
  EXPECT_NEAR(blur->standard_error, 0, 1e-5);
  EXPECT_EQ(metrics::edge_blur(metrics::pair_samples(stripes(), stripes()))->value, 0);
}

// An edge at an odd column becomes a pair of means, each half a step off where the filter changes a quarter:
// 2. Every second edge of these stripes lies so.
TEST(EdgeBlur, OfHalfTheResolutionIsOneOnAverage) {
  EXPECT_NEAR(metrics::edge_blur(metrics::pair_samples(halved(stripes()), stripes()))->value, 1, 0.1);
}

// Twice the image less its filtered self: what the filter takes from an edge is added to it.
TEST(EdgeBlur, OfAnImageThatIsSharperIsBelowZero) {
  auto sharp = stripes();
  const auto soft = filtered(sharp);
  for (std::size_t i = 0; i < sharp.pixels.size(); ++i)
    sharp.pixels[i] = 2 * sharp.pixels[i] - soft.pixels[i];
  EXPECT_NEAR(metrics::edge_blur(metrics::pair_samples(sharp, stripes()))->value, -1, 1e-5);
}

TEST(EdgeBlur, NoiseOfTheResultDoesNotMoveIt) {
  std::mt19937 random(1);
  for (int i = 0; i < 20; ++i) {
    const auto blur = metrics::edge_blur(metrics::pair_samples(noisy(stripes(), 0.1F, random), stripes()));
    ASSERT_TRUE(blur);
    EXPECT_GT(blur->standard_error, 0.01);
    EXPECT_NEAR(blur->value, 0, 4 * blur->standard_error);
  }
}

// It is in the error and in what the filter makes of the reference.
TEST(EdgeBlur, NoiseOfTheReferenceIsNoBlurOfTheResult) {
  std::mt19937 random(2);
  for (int i = 0; i < 20; ++i) {
    const auto blur =
        metrics::edge_blur(metrics::pair_samples(noisy(stripes(), 0.1F, random), noisy_reference(random)));
    ASSERT_TRUE(blur);
    EXPECT_NEAR(blur->value, 0, 4 * blur->standard_error);
  }
}

TEST(EdgeBlur, TheChannelsOfAPixelAreNotThreePixels) {
  std::mt19937 random(3);
  auto grey = noisy(stripes(), 0.1F, random);
  const double independent = metrics::edge_blur(metrics::pair_samples(grey, stripes()))->standard_error;
  for (std::size_t i = 0; i < grey.pixels.size(); i += 3)
    grey.pixels[i + 1] = grey.pixels[i + 2] = grey.pixels[i];
  EXPECT_NEAR(metrics::edge_blur(metrics::pair_samples(grey, stripes()))->standard_error / independent,
              std::sqrt(3.0), 0.1);
}

// The result hardly has any noise, but its variances say that there is some.
TEST(EdgeBlur, PassesByTheNoiseThatTheWholeImageShows) {
  std::mt19937 random(4);
  const auto reference = noisy_reference(random);
  auto result = noisy_reference(random);
  const auto clean = noisy(image::select_rgb(reference, ""), 0.0001F, random);
  for (int y = 0; y < kSide_px; ++y)
    for (int x = 0; x < kSide_px; ++x)
      for (std::size_t c = 0; c < 3; ++c) result.at(x, y, c) = clean.at(x, y, c);
  const auto pair = metrics::make_image_pair(result, reference, {}, {.looks = 12, .sample_ratio = 100});
  const auto blur = metrics::edge_blur(pair);
  ASSERT_TRUE(blur);
  ASSERT_LT(blur->standard_error, 0.01 * blur->seen_error);
  ASSERT_GT(blur->counted_error, 2 * blur->seen_error);
  const auto limits = metrics::compute_edge_blur(pair);
  EXPECT_GT(limits.to_pass->high - blur->value, 3 * blur->seen_error);
  EXPECT_LT(limits.to_pass->high - blur->value, 3 * blur->counted_error);
  EXPECT_GT(*limits.high - blur->value, 3 * blur->counted_error);
}

TEST(EdgeBlur, MaskedEdgesDoNotCount) {
  auto result = stripes();
  const auto blurred = filtered(result);
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < kSide_px; ++x)
      for (std::size_t c = 0; c < 3; ++c) result.at(x, y, c) = blurred.at(x, y, c);
  EXPECT_GT(metrics::edge_blur(metrics::pair_samples(result, stripes()))->value, 0.3);
  EXPECT_EQ(metrics::edge_blur(metrics::pair_samples(result, stripes(), {{{0, 0, kSide_px, 30}}, {}}))->value,
            0);
}

TEST(EdgeBlur, OfAnImageWithoutEdgesThereIsNone) {
  auto grey = image::make_image(kSide_px, kSide_px, {"R", "G", "B"});
  grey.pixels.assign(grey.pixels.size(), 0.5F);
  EXPECT_FALSE(metrics::edge_blur(metrics::pair_samples(grey, grey)));
}

// A gate that allows -1.1 to 0.9 allows sharpening by 1.1.
TEST(EdgeBlur, IsToldAsBlurOrAsSharpeningByANumberWithoutASign) {
  const metrics::Limits limits{-1.1, 0.9};
  EXPECT_EQ(metrics::describe_edge_blur({&metrics::kEdgeBlur, 1.63, {}, 1.5, 1.75}, limits),
            "edges are blurred by 1.63 (1.5 to 1.75) of a 3 x 3 px filter, from -1.1 to 0.9 is allowed");
  EXPECT_EQ(metrics::describe_edge_blur({&metrics::kEdgeBlur, -1.63, {}, -2.37, -1.21}, limits),
            "edges are sharpened by 1.63 (1.21 to 2.37) of a 3 x 3 px filter, from -0.9 to 1.1 is allowed");
  EXPECT_EQ(metrics::describe_edge_blur({&metrics::kEdgeBlur, -1.63, {}, -2.37, -1.21}, {-0.15, 0.15}),
            "edges are sharpened by 1.63 (1.21 to 2.37) of a 3 x 3 px filter, at most 0.15 is allowed");
}
