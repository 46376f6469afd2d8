// Light selection that has learned what is blocked: images of a room with half of its lamps behind a wall.
#include "tracer/choose_light.h"
#include "tracer/learn_light_selection.h"
#include "tracer/world/build_world.h"
#include "unit/tracer/scenes.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {

using namespace orbs;
using tests::error_of_mean;
using tests::mean_of_channel;

constexpr int kSamples = 64;

// Two rows of four lamps on either side of a wall from floor to ceiling; those behind it are the brighter
// ones.
tracer::World room(double half_size = 0.1) {
  std::string lamps;
  for (int x = 0; x < 4; ++x)
    for (int z = 0; z < 4; ++z)
      lamps += fmt::format(
          R"({}{{"type": "rect", "half_width": {}, "half_length": {}, "radiance": [{}, 20, 20],
                "matrix": [{{"translate": [{}, 2.5, {}]}}]}})",
          lamps.empty() ? "" : ", ", half_size, half_size, x < 2 ? 400 : 20, 2 * x - 3, 2 * z - 3);
  const auto text = tests::scene_text("[0.5, 1.5, 3.9]", "[2.5, 0.5, 0]", 32, 3, R"(
    "materials": [{"name": "m", "type": "lambert", "reflectance": [0.5, 0.5, 0.5]}],
    "meshes": [{"name": "p", "generator": "plane", "half_size": 4, "material": "m"},
               {"name": "c", "generator": "cube", "half_size": 1, "material": "m"}],
    "instances": [{"mesh": "p"}, {"mesh": "p", "matrix": [{"translate": [0, 3, 0]}]},
                  {"mesh": "c", "matrix": [{"translate": [0, 2, 0]}, {"scale": [0.05, 2, 4]}]}],
    "lights": [)" + lamps + "]",
                                      "50");
  return tracer::make_world(scene::load_scene_text("test.json", text, ORBS_SOURCE_DIR));
}

image::Image rendered(const tracer::World& world, std::uint64_t seed, int samples = kSamples) {
  const std::atomic<bool> never{false};
  return tracer::render(world, {.samples_per_pixel = samples, .seed = seed}, never,
                        [](const tracer::Progress&) {})
      .image;
}

void learn(tracer::World& world, int threads = 0) {
  tracer::learn_light_selection(world.light_bvh, world, {.samples_per_pixel = 1024, .threads = threads});
}

double median_variance(const image::Image& image) {
  std::vector<double> variances;
  for (std::size_t i = 0; i < image.pixels.size(); i += image.channel_count())
    if (image.pixels[i] > 0) variances.push_back(image.pixels[i + 3] / (image.pixels[i] * image.pixels[i]));
  const auto middle = variances.begin() + static_cast<std::ptrdiff_t>(variances.size() / 2);
  std::nth_element(variances.begin(), middle, variances.end());
  return *middle;
}

}  // namespace

TEST(LearnedLightSelection, HasLessNoiseWhereHalfOfTheLampsAreHidden) {
  auto world = room();
  const double without = median_variance(rendered(world, 1));
  learn(world);
  ASSERT_TRUE(world.light_bvh.has_learned());
  EXPECT_LT(median_variance(rendered(world, 1)), 0.5 * without);
}

TEST(LearnedLightSelection, HasTheSameExpectedImageAsTheTreeAlone) {
  auto world = room(0.6);  // so wide that BSDF sampling finds much of the light, which MIS weights

  const auto without = rendered(world, 1, 1024);
  learn(world);
  for (const auto direct_light : {tracer::DirectLight::Mis, tracer::DirectLight::Light}) {
    world.direct_light = direct_light;
    double mean = 0;
    double squares = 0;
    constexpr int kSeeds = 16;
    for (std::uint64_t seed = 2; seed < 2 + kSeeds; ++seed) {
      const auto image = rendered(world, seed);
      mean += mean_of_channel(image, 0) / kSeeds;
      squares += std::pow(error_of_mean(image, 0) / kSeeds, 2);
    }
    const double error = std::hypot(std::sqrt(squares), error_of_mean(without, 0));
    EXPECT_NEAR(mean, mean_of_channel(without, 0), 4 * error);
    EXPECT_LT(error, 0.01 * mean);  // otherwise the test could not fail
  }
}

TEST(LearnedLightSelection, LearnsTheSameWithAnyNumberOfThreads) {
  auto one = room();
  auto three = room();
  learn(one, 1);
  learn(three, 3);
  EXPECT_EQ(rendered(one, 1, 16).pixels, rendered(three, 1, 16).pixels);
}

TEST(LearnedLightSelection, IsChosenWhereItReducesNoise) {
  auto world = room();
  tracer::choose_light(world, {.samples_per_pixel = 1024}, {.paths = false, .connections = false});
  EXPECT_TRUE(world.light_bvh.has_learned());
}
