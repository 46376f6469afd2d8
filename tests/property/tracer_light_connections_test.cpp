// Connections of camera paths to the first hits of light paths, where light enters by way of one small wall.
#include "tracer/choose_light.h"
#include "tracer/learn_light_guides.h"
#include "tracer/world/build_world.h"
#include "unit/tracer/scenes.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using tests::error_of_mean;
using tests::mean_of_channel;
using tests::scene_text;

// A lamp below a floor shines on a small card beside it; all that the camera sees of the floor and the cube
// is lit by the card.
std::string behind_a_card(const std::string& cube, const std::string& card_half_size_m = "0.3") {
  return scene_text("[-0.5, 2.75, 1.5]", "[-0.5, 0, 0]", 24, 8,
                    R"("materials": [{"name": "floor", "type": "lambert", "reflectance": [0.5, 0.4, 0.3]},
                                     {"name": "cube", )" +
                        cube + R"(}],
                       "meshes": [{"name": "p", "generator": "plane", "half_size": 2, "material": "floor"},
                                  {"name": "card", "generator": "plane", "half_size": )" +
                        card_half_size_m + R"(, "material": "floor"},
                                  {"name": "c", "generator": "cube", "half_size": 0.2, "material": "cube"}],
                       "instances": [{"mesh": "p", "matrix": [{"translate": [1, 0, 0]}]},
                                     {"mesh": "card", "matrix": [{"translate": [-1.5, 0.3, 0]}, {"rotate_z": 90}]},
                                     {"mesh": "c", "matrix": [{"translate": [0, 0.21, 0]}, {"rotate_y": 30}]}],
                       "lights": [{"type": "rect", "half_width": 0.4, "half_length": 0.4, "radiance": [30, 30, 30],
                                   "matrix": [{"translate": [-0.75, -0.6, 0]}, {"rotate_z": -90}]}])",
                    "45");
}

const char* const kLambert = R"("type": "lambert", "reflectance": [0.5, 0.5, 0.5])";
const char* const kGlossy = R"("type": "ggx", "colour": [0.9, 0.8, 0.7], "alpha": 0.3)";
const char* const kMirror = R"("type": "mirror", "reflectance": [0.9, 0.9, 0.9])";
const char* const kGlass = R"("type": "glass", "colour": [1, 0.9, 1], "ior": 1.5)";

tracer::World world_of(const std::string& text) {
  return tracer::make_world(scene::load_scene_text("test.json", text, ORBS_SOURCE_DIR));
}

image::Image rendered(tracer::World& world, bool connects, const tracer::RenderSettings& settings) {
  const std::atomic<bool> never{false};
  world.connects_light_vertices = connects;
  return tracer::render(world, settings, never, [](const tracer::Progress&) {}).image;
}

// Median over the pixels of the relative error of red, by its variance.
double median_noise(const image::Image& image) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < image.pixels.size(); i += image.channel_count())
    if (image.pixels[i] > 0) errors.push_back(std::sqrt(image.pixels[i + 3]) / image.pixels[i]);
  std::nth_element(errors.begin(), errors.begin() + static_cast<int>(errors.size() / 2), errors.end());
  return errors[errors.size() / 2];
}

struct Cube {
  const char* name;
  const char* material;
};

class LightConnections : public testing::TestWithParam<Cube> {};

}  // namespace

TEST_P(LightConnections, HaveTheSameExpectedImage) {
  auto world = world_of(behind_a_card(GetParam().material));
  ASSERT_TRUE(tracer::supports_light_connections(world));
  const auto with = rendered(world, true, {.samples_per_pixel = 1024, .seed = 1});
  const auto without = rendered(world, false, {.samples_per_pixel = 16384, .seed = 2});
  const double error = std::hypot(error_of_mean(with, 0), error_of_mean(without, 0));
  EXPECT_NEAR(mean_of_channel(with, 0), mean_of_channel(without, 0), 4 * error);
  EXPECT_LT(error, 0.02 * mean_of_channel(with, 0));  // otherwise the test could not fail
}

TEST_P(LightConnections, HaveTheSameExpectedImageWithGuides) {
  auto world = world_of(behind_a_card(GetParam().material));
  const auto without = rendered(world, true, {.samples_per_pixel = 4096, .seed = 2});
  tracer::learn_light_guides(world, {.samples_per_pixel = 1024});
  ASSERT_FALSE(world.light_guides.empty());
  const auto with = rendered(world, true, {.samples_per_pixel = 1024, .seed = 1});
  const double error = std::hypot(error_of_mean(with, 0), error_of_mean(without, 0));
  EXPECT_NEAR(mean_of_channel(with, 0), mean_of_channel(without, 0), 4 * error);
  EXPECT_LT(error, 0.005 * mean_of_channel(with, 0));
}

INSTANTIATE_TEST_SUITE_P(Cubes,
                         LightConnections,
                         testing::Values(Cube{"lambert", kLambert},
                                         Cube{"glossy", kGlossy},
                                         Cube{"mirror", kMirror},
                                         Cube{"glass", kGlass}),
                         [](const auto& cube) { return std::string(cube.param.name); });

TEST(LightConnections, TakeMostOfTheNoiseWhereLightComesBySmallWall) {
  auto world = world_of(behind_a_card(kLambert));
  const auto with = rendered(world, true, {.samples_per_pixel = 256, .seed = 1});
  const auto without = rendered(world, false, {.samples_per_pixel = 256, .seed = 1});
  EXPECT_LT(median_noise(with), 0.3 * median_noise(without));
}

// Few light paths find a small card by power and cosine.
TEST(LightConnections, FindASmallCardByGuides) {
  auto world = world_of(behind_a_card(kLambert, "0.04"));
  const tracer::RenderSettings settings{.samples_per_pixel = 256, .seed = 1};
  const auto without = rendered(world, true, settings);
  tracer::choose_light(world, settings, {.selection = false, .paths = false});
  const auto with = rendered(world, true, settings);
  ASSERT_TRUE(world.connects_light_vertices);
  EXPECT_LT(median_noise(with), 0.5 * median_noise(without));
}

TEST(LightConnections, AreChosenWhereTheyReduceNoise) {
  auto behind = world_of(behind_a_card(kLambert));
  tracer::choose_light(behind, {.samples_per_pixel = 256}, {.selection = false, .paths = false});
  EXPECT_TRUE(behind.connects_light_vertices);
  const auto scene = scene::load_scene(ORBS_SOURCE_DIR "/data/cases/orbs/m1_lambert/101.json");
  auto box = tracer::make_world(scene);
  tracer::choose_light(box, {.samples_per_pixel = 64}, {.selection = false, .paths = false});
  EXPECT_FALSE(box.connects_light_vertices);
}

TEST(LightSelection, TheTreeIsChosenWhereItReducesNoise) {
  // A strong lamp above a board that shades all, and a weak one below it.
  const auto text = scene_text("[0, 1, 5]", "[0, 0.5, 0]", 24, 3, R"(
    "materials": [{"name": "floor", "type": "lambert", "reflectance": [0.5, 0.5, 0.5]}],
    "meshes": [{"name": "p", "generator": "plane", "half_size": 4, "material": "floor"}],
    "instances": [{"mesh": "p"}, {"mesh": "p", "matrix": [{"translate": [0, 2, 0]}]}],
    "lights": [{"type": "rect", "half_width": 2, "half_length": 2, "radiance": [9, 9, 9],
                "matrix": [{"translate": [0, 5, 0]}]},
               {"type": "rect", "half_width": 0.5, "half_length": 0.5, "radiance": [9, 9, 9],
                "matrix": [{"translate": [0, 1.5, 0]}]}])",
                               "40");
  auto world = world_of(text);
  const tracer::LightChoices selection{.paths = false, .connections = false};
  tracer::choose_light(world, {.samples_per_pixel = 256}, selection);
  EXPECT_FALSE(world.light_bvh.empty());
  auto balls =
      tracer::make_world(scene::load_scene(ORBS_SOURCE_DIR "/data/cases/orbs/m6_emission_texture/124.json"));
  EXPECT_FALSE(balls.light_bvh.empty());
  tracer::choose_light(balls, {.samples_per_pixel = 64}, selection);
  EXPECT_TRUE(balls.light_bvh.empty());
}

TEST(LightConnections, DoNotDependOnTheNumberOfThreads) {
  const auto with_threads = [](int threads) {
    auto world = world_of(behind_a_card(kLambert));
    tracer::learn_light_guides(world, {.samples_per_pixel = 64, .threads = threads});
    EXPECT_FALSE(world.light_guides.empty());
    return rendered(world, true, {.samples_per_pixel = 8, .threads = threads});
  };
  const auto one = with_threads(1);
  const auto two = with_threads(2);
  EXPECT_EQ(one.pixels, two.pixels);
}
