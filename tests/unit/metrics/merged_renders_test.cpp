#include "metrics/merged_renders.h"

#include "base/error.h"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

using namespace orbs;
using namespace orbs::metrics;

namespace {

constexpr int kSide_px = 24;

// Samples with mean 1 and variance 1; states their variance, or not.
image::Image render(int spp, bool states_variance, std::mt19937_64& random) {
  std::vector<std::string> names{"R", "G", "B"};
  if (states_variance) names.insert(names.end(), {"variance.R", "variance.G", "variance.B"});
  auto image = image::make_image(kSide_px, kSide_px, names);
  std::normal_distribution<double> mean(1, 1 / std::sqrt(spp));
  for (int y = 0; y < kSide_px; ++y)
    for (int x = 0; x < kSide_px; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        image.at(x, y, c) = static_cast<float>(mean(random));
        if (states_variance) image.at(x, y, c + 3) = 1.0F / static_cast<float>(spp);
      }
  return image;
}

MergedRenders merged(bool states_variance, int looks, std::mt19937_64& random) {
  MergedRenders all;
  int spp = 8;
  for (int look = 0; look < looks; ++look) {
    add_renders(all, {render(spp, states_variance, random), render(spp, states_variance, random)}, spp);
    if (look > 0) spp *= 2;
  }
  return all;
}

double mean_of(const image::Image& image, std::size_t channel) {
  double sum = 0;
  for (int y = 0; y < kSide_px; ++y)
    for (int x = 0; x < kSide_px; ++x) sum += static_cast<double>(image.at(x, y, channel));
  return sum / (kSide_px * kSide_px);
}

}  // namespace

TEST(MergedRenders, HaveTheMeanOfAllSamplesAndItsVariance) {
  std::mt19937_64 random(1);
  const auto all = merged(true, 4, random);
  EXPECT_EQ(all.samples, 16 * 8);
  EXPECT_EQ(all.renders, 8);
  EXPECT_NEAR(mean_of(all.mean, 3), 1.0 / all.samples, 1e-8) << "1 / n, whatever the sizes of the renders";
  double squares = 0;
  for (int y = 0; y < kSide_px; ++y)
    for (int x = 0; x < kSide_px; ++x)
      squares += std::pow(static_cast<double>(all.mean.at(x, y, 0)) - 1, 2) / (kSide_px * kSide_px);
  EXPECT_NEAR(squares * all.samples, 1, 0.2) << "five standard errors of 576 squares";
}

// 576 pixels of 7 degrees of freedom each: a standard deviation of 2.2 %.
TEST(MergedRenders, KnowTheirVarianceFromTheScatter) {
  std::mt19937_64 random(2);
  const auto all = merged(false, 4, random);
  EXPECT_NEAR(mean_of(all.mean, 3) * all.samples, 1, 0.11);
  EXPECT_NEAR(mean_of(merged(false, 1, random).mean, 3) * 16, 1, 0.3);
}

TEST(MergedRenders, HoldTwoHalvesThatShareNoSample) {
  std::mt19937_64 random(3);
  const auto all = merged(true, 3, random);
  double product = 0;
  for (std::size_t i = 0; i < all.halves[0].pixels.size(); ++i) {
    const double a = static_cast<double>(all.halves[0].pixels[i]);
    const double b = static_cast<double>(all.halves[1].pixels[i]);
    product += (a - 1) * (b - 1);
    const double mean = static_cast<double>(all.mean.pixels[6 * (i / 3) + i % 3]);
    EXPECT_NEAR((a + b) / 2, mean, 1e-5);
  }
  const double n = static_cast<double>(all.halves[0].pixels.size());
  EXPECT_NEAR(product / n, 0, 5 * 2.0 / all.samples / std::sqrt(n));
}

TEST(MergedRenders, ComeBackFromTheirFiles) {
  std::mt19937_64 random(4);
  auto all = merged(false, 2, random);
  auto again = merged_renders_of(all.mean, halves_image(all), all.renders, all.samples);
  const std::array two{render(8, false, random), render(8, false, random)};
  add_renders(all, two, 8);
  add_renders(again, two, 8);
  EXPECT_EQ(all.mean.pixels, again.mean.pixels);
  EXPECT_EQ(all.halves[1].pixels, again.halves[1].pixels);
  EXPECT_FALSE(again.states_variance);
}

TEST(MergedRenders, RefuseWhatIsNotOfOneScene) {
  std::mt19937_64 random(5);
  auto all = merged(true, 1, random);
  const auto without = render(8, false, random);
  EXPECT_THROW(add_renders(all, {without, without}, 8), InputError);
  MergedRenders none;
  const auto same = render(8, true, random);
  EXPECT_THROW(add_renders(none, {same, same}, 8), InputError);
}
