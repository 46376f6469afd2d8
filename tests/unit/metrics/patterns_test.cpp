#include "metrics/patterns.h"

#include "base/random.h"
#include "image/colour.h"
#include "metrics/describe.h"

#include <array>
#include <cmath>
#include <functional>
#include <string>

#include <gtest/gtest.h>

namespace {

using namespace orbs::metrics;
using orbs::image::Image;
using Rgb = std::array<double, 3>;

constexpr int kSide_px = 96;

// Coloured waves with shadows and highlights, at any place between pixels.
Rgb waves(double x, double y) {
  const double wave = 1 + 0.9 * std::sin(x / 7) * std::cos(y / 5);
  return {0.8 * wave, 0.5 * wave + 0.1 * std::sin(x / 11), 0.3 + 0.25 * std::cos(y / 9)};
}

using Shading = std::function<Rgb(double x, double y)>;

// `relative_noise` of each channel, the same in all three as in a path tracer.
Image rendered(const Shading& shading, double relative_noise, std::uint64_t seed) {
  Image image = orbs::image::make_image(kSide_px, kSide_px, {"R", "G", "B"});
  for (int y = 0; y < kSide_px; ++y)
    for (int x = 0; x < kSide_px; ++x) {
      const auto key = orbs::mix(seed, static_cast<std::uint64_t>(y * kSide_px + x));
      const double noise = 1 + relative_noise * std::sqrt(12.0) * (orbs::unit_random(key) - 0.5);
      const Rgb rgb = shading(x, y);
      for (std::size_t c = 0; c < 3; ++c) image.at(x, y, c) = static_cast<float>(rgb.at(c) * noise);
    }
  return image;
}

std::optional<PatternFinding> found(const Shading& shading, std::uint64_t seed = 1) {
  const Image reference = rendered(waves, 0.01, 1000);
  const auto findings = find_patterns(pair_samples(rendered(shading, 0.05, seed), reference), 1e-4);
  return findings.empty() ? std::nullopt : std::optional(findings.front());
}

void expect_pattern(const Shading& shading, const std::string& words, double amplitude) {
  const auto finding = found(shading);
  ASSERT_TRUE(finding) << words;
  EXPECT_EQ(describe(*finding).substr(0, words.size()), words) << describe(*finding);
  EXPECT_NEAR(std::fabs(finding->amplitude), amplitude, 0.25 * amplitude) << words;
  EXPECT_LT(finding->low, finding->amplitude);
  EXPECT_LT(finding->amplitude, finding->high);
}

Rgb scaled(Rgb rgb, double factor) {
  for (double& value : rgb) value *= factor;
  return rgb;
}

}  // namespace

TEST(Patterns, AreSaidWithAnIntervalThatHoldsThem) {
  const orbs::metrics::Pattern gamma{
      .more = "of a higher gamma", .less = "of a lower gamma", .negligible = 0.002, .largest = 0.3};
  EXPECT_EQ(describe({&gamma, 0.0107, -0.0325, 0.0538, 9}), "of a higher gamma by 1.07 % (-3.25 to 5.38)");
  EXPECT_EQ(describe({&gamma, -0.05, -0.06, -0.04, 9}), "of a lower gamma by 5 % (4 to 6)");
}

// A fit of the shadows took more than all of their light: "darker in its shadows by 133 %".
TEST(Patterns, NothingIsDarkerByMoreThanAllOfItsLight) {
  const orbs::metrics::Pattern shadows{
      .more = "brighter in its shadows",
      .less = "darker in its shadows",
      .beyond_all = "darker in its shadows, where most of the light is missing"};
  EXPECT_EQ(describe({&shadows, -1.33, -1.4, -1.2, 9}), shadows.beyond_all);
  EXPECT_EQ(describe({&shadows, -0.95, -1.1, -0.8, 9}), "darker in its shadows by 95 % (80 to 100)");
  EXPECT_EQ(describe({&shadows, 3.63, 3.5, 3.8, 9}), "brighter in its shadows by 363 % (350 to 380)");
  using orbs::metrics::lightness_text;
  EXPECT_EQ(lightness_text({-0.95, -1.1, -0.8}), "95 % darker (80 to 100 %)");
  EXPECT_EQ(lightness_text({-1.33, -1.4, -1.2}), "of negative light, -33 % of what is right (-40 to -20 %)");
  EXPECT_EQ(lightness_text({2, 1.9, 2.1}), "200 % brighter (190 to 210 %)");
}

// A pattern is the first order of its fault, and says nothing of errors that are far larger.
TEST(Patterns, AreNotSaidOutOfTheirRange) {
  const orbs::metrics::Pattern gamma{
      .more = "of a higher gamma", .less = "of a lower gamma", .negligible = 0.002, .largest = 0.3};
  EXPECT_TRUE(is_within_range({&gamma, -0.05, -0.06, -0.04, 9}));
  EXPECT_FALSE(is_within_range({&gamma, -0.687, -1.32, -0.0565, 9}));
  EXPECT_FALSE(is_within_range({&gamma, -0.2, -0.35, -0.05, 9}));
}

// One in 10,000 is promised: none in 200 has the probability 0.98.
TEST(Patterns, NoneIsSeenInNoise) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) EXPECT_FALSE(found(waves, seed)) << seed;
}

TEST(Patterns, AreNamedWithTheirSize) {
  const double middle = (kSide_px - 1) / 2.0;
  expect_pattern([&](double x, double y) { return scaled(waves(x, y), 1 + 0.05 * (x - middle) / middle); },
                 "brighter towards the right edge", 0.05);
  expect_pattern([&](double x, double y) { return scaled(waves(x, y), 1 - 0.05 * (y - middle) / middle); },
                 "brighter towards the upper edge", 0.05);
  expect_pattern([](double x, double y) { return waves(x + 0.2, y); }, "shifted to the left by 0.", 0.2);
  expect_pattern([](double x, double y) { return waves(x, y - 0.2); }, "shifted down by 0.", 0.2);
  expect_pattern(
      [&](double x, double y) { return waves(middle + (x - middle) / 1.01, middle + (y - middle) / 1.01); },
      "scaled up", 0.01);
  expect_pattern([&](double x, double y) { return waves(x + 0.01 * (y - middle), y - 0.01 * (x - middle)); },
                 "rotated clockwise", 0.01);
  expect_pattern(
      [](double x, double y) {
        Rgb rgb = waves(x, y);
        const double grey = 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
        for (double& value : rgb) value += 0.03 * (grey - value);
        return rgb;
      },
      "of less saturated colours", 0.03);
  expect_pattern(
      [](double x, double y) {
        return scaled(waves(x, y), (static_cast<int>(x) + static_cast<int>(y)) % 2 == 0 ? 1.03 : 0.97);
      },
      "chequered", 0.03);
}

TEST(Patterns, ABlackReferenceHasNone) {
  const Image black = orbs::image::make_image(kSide_px, kSide_px, {"R", "G", "B"});
  EXPECT_TRUE(find_patterns(pair_samples(rendered(waves, 0.05, 1), black), 1e-4).empty());
}

// What docs/understand/verdicts.md promises to refuse is refused, and half of it is not.
TEST(Patterns, FailFromThePromisedSize) {
  const auto moved_px = [](double by) { return [by](double x, double y) { return waves(x - by, y); }; };
  const auto excess = [](const Shading& shading) { return found(shading).value_or(PatternFinding{}).excess; };
  EXPECT_GT(excess(moved_px(0.5)), 1);
  EXPECT_LT(excess(moved_px(0.25)), 1);
  const auto faded = [](double by) {
    return [by](double x, double y) {
      Rgb rgb = waves(x, y);
      const double grey = orbs::image::luminance(rgb[0], rgb[1], rgb[2]);
      for (double& value : rgb) value += by * (grey - value);
      return rgb;
    };
  };
  EXPECT_GT(excess(faded(0.03)), 1);
  EXPECT_LT(excess(faded(0.01)), 1);
}
