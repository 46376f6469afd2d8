#include "base/random.h"
#include "metrics/seeds.h"
#include "studies/bench/numbers.h"
#include "studies/bench/report.h"
#include "studies/seed_statistics.h"

#include <cmath>

#include <gtest/gtest.h>

using namespace orbs;
using namespace orbs::studies;

namespace {

// A process that needs `start` seconds and then `per_spp` for each sample.
BenchRound timed_round(double start, double per_spp) {
  const auto render = [&](int spp) {
    return run::RenderCost{spp, start + per_spp * spp, (start + per_spp * spp) / 2, 0.001, 0.5};
  };
  return {render(8), render(64)};
}

BenchRecord two_renderers() {
  BenchRecord record;
  record.settings.size_px = 100;
  record.scene = "box";
  record.renderers = {{"fast", "1", {timed_round(0.1, 0.01), timed_round(0.2, 0.02)}, SeedNoise{0.002, 40}},
                      {"slow", "2", {timed_round(3, 0.04), timed_round(2, 0.04)}, SeedNoise{0.001, 43}}};
  return record;
}

// Independent uniform numbers of variance s^2 around 0.5.
image::Image noisy_image(std::uint64_t seed, double s) {
  auto image = image::make_image(64, 64, {"R", "G", "B"});
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = static_cast<float>(0.5 + s * std::sqrt(12.0) * (unit_random(mix(seed, i)) - 0.5));
  return image;
}

}  // namespace

TEST(Spread, IsTheMiddleAndTheEnds) {
  EXPECT_FALSE(spread_of({}));
  EXPECT_EQ(spread_of({3, 1, 2})->median, 2);
  EXPECT_EQ(spread_of({4, 1, 3, 2})->median, 2.5);
  EXPECT_EQ(spread_of({4, 1, 3, 2})->least, 1);
  EXPECT_EQ(spread_of({4, 1, 3, 2})->most, 4);
}

// 10^4 pixels; 0.01 and 0.02 s per sample of all of them.
TEST(Bench, TheStartOfAProgramDropsOutOfItsRate) {
  const auto record = two_renderers();
  const auto rate = paths_per_cpu_second(record, record.renderers[0]);
  ASSERT_TRUE(rate);
  EXPECT_NEAR(rate->most, 1e6, 1e-3);
  EXPECT_NEAR(rate->least, 5e5, 1e-3);
  EXPECT_NEAR(paths_per_second(record, record.renderers[0])->most, 2e6, 1e-3);  // half the time by the wall
  EXPECT_NEAR(start_cpu_seconds(record.renderers[1])->most, 3, 1e-9);
  EXPECT_EQ(traversal_share(record.renderers[0])->median, 0.5);
}

TEST(Bench, TheRatioIsFormedRoundByRound) {
  const auto record = two_renderers();
  const auto ratio = speed_ratio(record.renderers[0], record.renderers[1]);
  ASSERT_TRUE(ratio);
  EXPECT_NEAR(ratio->least, 2, 1e-9);
  EXPECT_NEAR(ratio->most, 4, 1e-9);
}

// 64 samples cost the fast one 0.96 s in the median and the slow one 2.56 s, so that the slow one has 0.375
// of its samples in the time of the fast one: 0.001 / 0.375, and 10 log10(0.375) = -4.2597 dB.
TEST(Bench, NoiseAtEqualTimeScalesWithTheSamples) {
  const auto record = two_renderers();
  const auto seconds = equal_cpu_seconds(record);
  ASSERT_TRUE(seconds);
  EXPECT_NEAR(*seconds, 0.96, 1e-9);
  EXPECT_NEAR(noise_at(record.renderers[0], *seconds)->relative_mse, 0.002, 1e-12);
  EXPECT_NEAR(noise_at(record.renderers[1], *seconds)->relative_mse, 0.001 / 0.375, 1e-9);
  EXPECT_NEAR(noise_at(record.renderers[1], *seconds)->psnr_srgb8_db, 43 - 4.2597, 1e-3);
}

TEST(Bench, TimesThatSayNothingGiveNoNumber) {
  auto record = two_renderers();
  for (auto& round : record.renderers[0].rounds) round.large.cpu_seconds = round.small.cpu_seconds;
  EXPECT_FALSE(paths_per_cpu_second(record, record.renderers[0]));
  EXPECT_FALSE(equal_cpu_seconds(record));
  EXPECT_FALSE(speed_ratio(record.renderers[0], record.renderers[1]));
  EXPECT_NE(bench_json(record).find(R"("equal_cpu_seconds": null)"), std::string::npos);
  EXPECT_NE(bench_table(record).find("  -"), std::string::npos);
}

TEST(Bench, TheTableNamesWhatIsMissing) {
  auto record = two_renderers();
  record.left_out = {{"third", "there is no program 'third' here"}};
  EXPECT_NE(bench_table(record).find("third is not in the table: there is no program 'third' here"),
            std::string::npos);
  EXPECT_NE(bench_table(record).find("2.00 to 4.00"), std::string::npos) << bench_table(record);
}

// s = 0.01 at a level of 0.5: s^2 / (0.25 + 0.01). In sRGB steps the slope at 0.5 is 1.055 / 2.4 *
// 0.5^(1/2.4 - 1) * 255 = 167.9, so s is 1.679 steps, and 20 log10(255 / 1.679) = 43.63 dB.
TEST(SeedNoise, IsThatOfOneImage) {
  const std::vector<image::Image> images{noisy_image(1, 0.01), noisy_image(2, 0.01), noisy_image(3, 0.01)};
  const auto noise = noise_of_seeds(images, metrics::mean_of(images), 1);
  EXPECT_NEAR(noise.relative_mse, 1e-4 / 0.26, 0.02 * 1e-4 / 0.26);
  EXPECT_NEAR(noise.psnr_srgb8_db, 43.63, 0.1);
}

TEST(SeedNoise, TheMeanIsTheMeanOfAllImages) {
  auto dark = image::make_image(2, 2, {"R", "G", "B"});
  auto bright = dark;
  std::fill(bright.pixels.begin(), bright.pixels.end(), 3.0F);
  EXPECT_EQ(metrics::mean_of({dark, bright, bright}).at(1, 1, 2), 2.0F);
}

TEST(BenchNumbers, TheHarnessAddsTheDifferenceOfTheMedians) {
  auto record = two_renderers();
  EXPECT_FALSE(orbs::studies::overhead_ms(record));
  record.overhead = {{12, 11, 20}, {2, 1, 9}};
  EXPECT_EQ(orbs::studies::overhead_ms(record), 10);
  // The large render of the quicker one: 0.001 s of watching in (0.1 + 64 * 0.01) / 2 s.
  EXPECT_NEAR(orbs::studies::watching_share(record).value(), 0.001 / 0.37, 1e-12);
}
