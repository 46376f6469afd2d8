// Noise that pixels have in common, as the two renders of each look tell it.
#include "metrics/common_noise.h"

#include "metrics/image_pair.h"
#include "metrics/merged_renders.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

using namespace orbs;
using metrics::RendersApart;

namespace {

constexpr int kSide_px = 64;

// Grey with noise of its own in each pixel, which a filter of `side_px` px spreads, and a part that all
// share.
image::Image noisy(float own, int side_px, float shared, std::mt19937& random) {
  std::normal_distribution<float> normal(0, 1);
  std::vector<float> noise(static_cast<std::size_t>(kSide_px) * kSide_px);
  for (float& value : noise) value = normal(random);
  const float of_all = shared * normal(random);
  auto image = image::make_image(kSide_px, kSide_px, {"R", "G", "B"});
  for (int y = 0; y < kSide_px; ++y)
    for (int x = 0; x < kSide_px; ++x) {
      float sum = 0;
      for (int v = 0; v < side_px; ++v)
        for (int u = 0; u < side_px; ++u)
          sum += noise[static_cast<std::size_t>((y + v) % kSide_px * kSide_px + (x + u) % kSide_px)];
      for (std::size_t c = 0; c < 3; ++c)
        image.at(x, y, c) = 1 + own * sum / static_cast<float>(side_px * side_px) + of_all;
    }
  return image;
}

metrics::ImagePair pair_of(float own, int side_px, float shared, int looks, std::uint32_t seed) {
  std::mt19937 random(seed);
  metrics::MergedRenders merged;
  metrics::PairSettings settings{.looks = 12};
  for (int look = 0; look < looks; ++look) {
    const std::array renders{noisy(own, side_px, shared, random), noisy(own, side_px, shared, random)};
    settings.apart.push_back(metrics::renders_apart(renders[0], renders[1], 2));
    metrics::add_renders(merged, renders, 1);
  }
  settings.halves = &merged.halves;
  auto reference = image::make_image(kSide_px, kSide_px, {"R", "G", "B"});
  for (float& value : reference.pixels) value = 1;
  return metrics::make_image_pair(merged.mean, reference, {}, settings);
}

}  // namespace

// Of one sample with the deviation s the difference of two renders of n samples each has the variance 2 s^2 /
// n.
TEST(CommonNoise, OfTheMeanFollowsFromTheDifferencesOfTheLooks) {
  const auto noise = metrics::common_noise_of({{16, {0.5, 0, 0}}, {16, {-0.5, 0, 0}}, {32, {0.25, 0, 0}}});
  EXPECT_EQ(noise.degrees, 3);
  EXPECT_NEAR(noise.error[0], std::sqrt((1.0 + 1.0 + 0.5) / 3 / 64), 1e-12);
  EXPECT_EQ(noise.error[1], 0);
  EXPECT_EQ(metrics::common_noise_of({}).degrees, 0);
}

// A filter of 3 x 3 px leaves the noise of a large area and takes all but a ninth of a pixel's.
TEST(CommonNoise, OverAreasIsNinefoldBehindAFilter) {
  const auto filtered = pair_of(0.3F, 3, 0, 4, 1).area_noise;
  EXPECT_GT(filtered.over_8px[1], 4);
  EXPECT_LT(filtered.over_8px[1], 9);
  EXPECT_GE(filtered.over_16px[1], filtered.over_8px[1]);
  for (std::uint32_t seed = 1; seed <= 5; ++seed)
    EXPECT_LT(pair_of(0.3F, 1, 0, 4, seed).area_noise.over_16px[1], 1.8) << seed;
}

// By its pixels it is sure of a mean that the next look will not repeat.
TEST(CommonNoise, MakesNoRightImageWrong) {
  for (const auto& [filter_px, shared] : {std::pair{3, 0.0F}, {1, 0.1F}, {3, 0.1F}})
    for (std::uint32_t seed = 1; seed <= 4; ++seed)
      for (int looks = 1; looks <= 4; ++looks) {
        const auto pair =
            pair_of(0.1F, filter_px, shared, looks, 100 * seed + static_cast<std::uint32_t>(looks));
        const auto& ratio = *pair.noise.mean_ratio[0];
        EXPECT_LE(ratio.low, 0) << filter_px << ' ' << shared << ' ' << seed << ' ' << looks;
        EXPECT_GE(ratio.high, 0) << filter_px << ' ' << shared << ' ' << seed << ' ' << looks;
        for (const auto& window : pair.noise.windows) EXPECT_LT(window->value, 0.01) << seed;
        EXPECT_LT(pair.noise.line->value, 0.02) << seed;
      }
}
