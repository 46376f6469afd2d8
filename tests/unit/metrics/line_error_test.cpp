// Lines that are one pixel wide, with and without noise.
#include "metrics/line_error.h"

#include "images.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

using namespace orbs;
using metrics_test::grey_image;

namespace {

constexpr int kSide_px = 96;

float light_at(int x, int y) {
  return 0.3F + 0.002F * static_cast<float>(x) + 0.1F * static_cast<float>(y / 40);
}

// States its variance; without noise it is 0.
image::Image image_of(const std::function<float(int, int)>& value, float deviation, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<float> normal(0, 1);
  auto image =
      image::make_image(kSide_px, kSide_px, {"R", "G", "B", "variance.R", "variance.G", "variance.B"});
  for (int y = 0; y < kSide_px; ++y)
    for (int x = 0; x < kSide_px; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        const float right = value(x, y);
        image.at(x, y, c) = right * (1 + deviation * normal(random));
        image.at(x, y, c + 3) = right * right * deviation * deviation;
      }
  return image;
}

metrics::LineError error_of(const std::function<float(int, int)>& value,
                            float deviation,
                            std::uint32_t seed = 1) {
  return *metrics::line_error(
      metrics::pair_samples(image_of(value, deviation, seed), image_of(light_at, 0, seed)));
}

using Line = std::function<bool(int, int)>;

std::function<float(int, int)> darker_on(const Line& line, float factor) {
  return [line, factor](int x, int y) { return light_at(x, y) * (line(x, y) ? factor : 1.0F); };
}

}  // namespace

TEST(LineError, FindsRowsColumnsDiagonalsAndArcs) {
  const std::vector<std::pair<const char*, Line>> lines{
      {"row", [](int, int y) { return y == 37; }},
      {"column", [](int x, int) { return x == 80; }},
      {"diagonal", [](int x, int y) { return x == y; }},
      {"other diagonal", [](int x, int y) { return x + y == kSide_px - 1; }},
      {"steep", [](int x, int y) { return x == 20 + y / 3; }},
      {"flat", [](int x, int y) { return y == 70 - x / 4; }},
      {"arc", [](int x, int y) { return std::lround(std::hypot(x - 48, y - 48)) == 40; }},
      {"border of a tile", [](int x, int y) { return x == 32 && y >= 32 && y < 64; }},
  };
  for (const auto& [name, line] : lines) {
    EXPECT_GT(error_of(darker_on(line, 0.6F), 0).value, 0.2) << name;
    EXPECT_GT(error_of(darker_on(line, 0.6F), 0.05F).value, 0.1) << name;
  }
}

TEST(LineError, SaysWhereItIs) {
  const auto error = error_of(darker_on([](int x, int y) { return x == 40 && y >= 32 && y < 64; }, 0.5F), 0);
  EXPECT_NEAR(error.value, 0.5, 0.03);
  EXPECT_LE(error.where.x0, 40);
  EXPECT_GT(error.where.x1, 40);
  EXPECT_LE(error.where.x1 - error.where.x0, 3);
  EXPECT_GE(error.where.y0, 32);
  EXPECT_LE(error.where.y1, 64);
}

TEST(LineError, IsNoneInRightImages) {
  for (std::uint32_t seed = 1; seed <= 10; ++seed)
    for (const float deviation : {0.02F, 0.3F})
      EXPECT_EQ(error_of(light_at, deviation, seed).value, 0) << seed;
}

// An edge that lies a tenth of a pixel away is no line that is lost.
TEST(LineError, AllowsEdgesThatLieSlightlyAway) {
  const auto edge_at = [](double at) {
    return [at](int x, int) {
      const double covered = std::clamp(at - x, 0.0, 1.0);
      return static_cast<float>(0.1 + 0.9 * covered);
    };
  };
  const auto error = metrics::line_error(
      metrics::pair_samples(image_of(edge_at(40.6), 0, 1), image_of(edge_at(40.5), 0, 1)));
  EXPECT_EQ(error->value, 0);
}

TEST(LineError, NeedsLight) {
  const auto black = [](int, int) { return 0.0F; };
  EXPECT_FALSE(metrics::line_error(metrics::pair_samples(image_of(black, 0, 1), image_of(black, 0, 1))));
}
