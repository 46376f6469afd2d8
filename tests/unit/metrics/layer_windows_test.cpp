// Layers relative to what stands at their place: small scales, and the ways of right renderers.
#include "image/reduced_precision.h"
#include "metrics/image_pair.h"
#include "metrics/surface_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

using namespace orbs;

namespace {

constexpr int kWidth = 48;
constexpr int kHeight = 32;
constexpr double kLimit = 0.001;  // of the shipped case of layers

// What a place in the image shows of a layer, in px from the upper left corner; its parts.
using Surface = std::function<std::array<double, 3>(double x, double y)>;

// A floor that runs away: its depth is 2 m over the distance from the horizon, two rows above the image.
std::array<double, 3> floor_depth(double, double y) { return {60 / (y + 2), 0, 0}; }

// The normals of a cylinder that lies across the image.
std::array<double, 3> cylinder(double, double y) {
  const double a = (y - 12) / 25;
  return {0, a, std::sqrt(1 - a * a)};
}

// As a reference knows them, by many places: mean, least, most of each pixel.
image::Image reference_of(const Surface& surface, const std::vector<std::string>& channels) {
  constexpr int kSide = 16;
  std::vector<std::string> names{"R", "G", "B"};
  for (const auto& name : channels) names.insert(names.end(), {name, "least." + name, "most." + name});
  auto image = image::make_image(kWidth, kHeight, names);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (std::size_t c = 0; c < channels.size(); ++c) {
        double sum = 0;
        double least = 1e9;
        double most = -1e9;
        for (int i = 0; i <= kSide; ++i)
          for (int j = 0; j <= kSide; ++j) {
            const double end = (i % kSide == 0 ? 0.5 : 1) * (j % kSide == 0 ? 0.5 : 1);
            const double at =
                surface(x + i / static_cast<double>(kSide), y + j / static_cast<double>(kSide)).at(c);
            sum += end * at / (kSide * kSide);
            least = std::min(least, at);
            most = std::max(most, at);
          }
        image.at(x, y, 3 + 3 * c) = static_cast<float>(sum);
        image.at(x, y, 4 + 3 * c) = static_cast<float>(least);
        image.at(x, y, 5 + 3 * c) = static_cast<float>(most);
      }
  return image;
}

// Where in a pixel sample i lies.
using Place = std::function<std::array<double, 2>(int i)>;

image::Image rendered(const Surface& surface,
                      const std::vector<std::string>& channels,
                      int samples,
                      const Place& place) {
  std::vector<std::string> names{"R", "G", "B"};
  names.insert(names.end(), channels.begin(), channels.end());
  auto image = image::make_image(kWidth, kHeight, names);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      std::array<double, 3> sum{};
      for (int i = 0; i < samples; ++i) {
        const auto [u, v] = place(i);
        const auto value = surface(x + u, y + v);
        for (std::size_t c = 0; c < 3; ++c) sum.at(c) += value.at(c) / samples;
      }
      for (std::size_t c = 0; c < channels.size(); ++c) image.at(x, y, 3 + c) = static_cast<float>(sum.at(c));
    }
  return image;
}

Place at_random(std::mt19937& random) {
  return [&random](int) {
    std::uniform_real_distribution<double> in_pixel(0, 1);
    const double u = in_pixel(random);
    return std::array{u, in_pixel(random)};
  };
}

std::array<double, 2> in_the_middle(int) { return {0.5, 0.5}; }

Surface times(const Surface& surface, double factor) {
  return [=](double x, double y) {
    auto value = surface(x, y);
    for (double& part : value) part *= factor;
    return value;
  };
}

metrics::MetricResult error(const image::Image& result, const image::Image& reference) {
  return metrics::compute_layer_error(metrics::make_image_pair(result, reference, {}, {.looks = 12}));
}

const std::vector<std::string> kDepth{"depth.Z"};
const std::vector<std::string> kNormal{"normal.X", "normal.Y", "normal.Z"};

}  // namespace

TEST(LayerWindows, DepthThatIsOffByAHundredthEverywhereIsWrong) {
  const auto reference = reference_of(floor_depth, kDepth);
  std::mt19937 random(1);
  for (const double factor : {1.01, 0.99}) {
    const auto scaled = times(floor_depth, factor);
    EXPECT_GT(*error(rendered(scaled, kDepth, 8, at_random(random)), reference).value, kLimit) << factor;
    EXPECT_GT(*error(rendered(scaled, kDepth, 1, in_the_middle), reference).value, kLimit) << factor;
  }
}

TEST(LayerWindows, NormalsOfAnotherLengthAreWrong) {
  const auto reference = reference_of(cylinder, kNormal);
  const auto longer = error(rendered(times(cylinder, 1.005), kNormal, 1, in_the_middle), reference);
  EXPECT_GT(*longer.value, kLimit);
  EXPECT_NE(longer.what.find("normal"), std::string::npos) << longer.what;
}

TEST(LayerWindows, RightRenderersArePassed) {
  for (const auto& [surface, channels] :
       {std::pair<Surface, std::vector<std::string>>{floor_depth, kDepth}, {cylinder, kNormal}}) {
    const auto reference = reference_of(surface, channels);
    EXPECT_LT(*error(rendered(surface, channels, 1, in_the_middle), reference).value, kLimit);
    const auto alike = [](int i) { return std::array{i / 8.0, (5 * i % 8) / 8.0}; };
    EXPECT_LT(*error(rendered(surface, channels, 8, alike), reference).value, kLimit);
    std::mt19937 random(7);
    for (int seed = 0; seed < 30; ++seed)
      for (const int samples : {1, 2, 8, 32})
        EXPECT_LT(*error(rendered(surface, channels, samples, at_random(random)), reference).value, kLimit)
            << samples;
  }
}

TEST(LayerWindows, HalfFloatsAreRight) {
  for (const auto& [surface, channels] :
       {std::pair<Surface, std::vector<std::string>>{floor_depth, kDepth}, {cylinder, kNormal}}) {
    const auto reference = reference_of(surface, channels);
    auto halves = rendered(surface, channels, 1, in_the_middle);
    for (float& value : halves.pixels) value = image::float_of_half(image::half_bits(value));
    EXPECT_LT(*error(halves, reference).value, kLimit);
  }
}

// Boards of which each pixel shows a tenth: most samples miss them, and then scatter as what is beside them.
TEST(LayerWindows, AThingThatFewSamplesMeetIsRight) {
  const Surface boards = [](double x, double y) {
    return std::array{y - std::floor(y) < 0.1 ? 3.0 : 1 + 0.01 * (x - std::floor(x)), 0.0, 0.0};
  };
  auto reference = reference_of(boards, kDepth);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) reference.at(x, y, 3) = 0.1F * 3 + 0.9F * 1.005F;
  std::mt19937 random(11);
  for (int seed = 0; seed < 100; ++seed)
    EXPECT_LT(*error(rendered(boards, kDepth, 1, at_random(random)), reference).value, kLimit);
}
