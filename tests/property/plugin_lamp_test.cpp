// Glowing shapes of plug-ins as lamps: light sampling, BSDF sampling and light paths have one expected image.
#include "property/hashed_numbers.h"
#include "tracer/plugins/plugin_emitter.h"
#include "unit/tracer/scenes.h"

#include <cmath>

#include <gtest/gtest.h>

using namespace orbs;
using tests::uniform;

namespace {

constexpr double kHalfSize = 0.7;
constexpr double kCurvature = 0.9;
constexpr int kSide_px = 16;

tracer::PluginLibraries libraries() {
  return {{"saddle", tracer::open_plugin(ORBS_BINARY_DIR "/plugins/saddle.so")}};
}

// A glowing saddle, stretched, turned and curved, which shades itself; a floor that scatters, a glass ball, a
// glossy wall and a lamp of another kind.
scene::Scene scene_with_saddle() {
  const auto text = tests::scene_text("[0, 2.5, 6]", "[0, 0.7, 0]", kSide_px, 5, R"(
    "materials": [{"name": "floor", "type": "lambert", "reflectance": [0.7, 0.6, 0.4]},
                  {"name": "glass", "type": "glass", "colour": [1, 0.9, 1], "ior": 1.5},
                  {"name": "glossy", "type": "ggx", "colour": [0.9, 0.8, 0.7], "alpha": 0.2},
                  {"name": "glow", "type": "emission", "radiance": [4, 3, 2]}],
    "meshes": [{"name": "p", "generator": "plane", "half_size": 6, "material": "floor"},
               {"name": "ball", "generator": "sphere", "radius": 0.6, "segments": 24, "material": "glass"},
               {"name": "wall", "generator": "plane", "half_size": 2, "material": "glossy"}],
    "instances": [{"mesh": "p"}, {"mesh": "ball", "matrix": [{"translate": [-0.9, 0.9, 0]}]},
                  {"mesh": "wall", "matrix": [{"translate": [0, 1.5, -2]}, {"rotate_x": 80}]}],
    "shapes": [{"type": "plugin", "plugin": "saddle", "numbers": {"half_size": 0.7, "k": 0.9}, "material": "glow",
                "matrix": [{"translate": [0.6, 2.2, 0.3]}, {"rotate_x": 25}, {"scale": [1.2, 0.6, 0.9]}]}],
    "lights": [{"type": "rect", "half_width": 0.4, "half_length": 0.4, "radiance": [3, 3, 3],
                "matrix": [{"translate": [-1.5, 3.2, 0.2]}]}])",
                                      "40");
  return scene::load_scene_text("test.json", text, ORBS_SOURCE_DIR);
}

tracer::World world_of(const scene::Scene& scene, tracer::WorldSettings settings) {
  settings.plugins = libraries();
  return tracer::make_world(scene, settings);
}

struct Choice {
  const char* name;
  tracer::WorldSettings world;
  bool connects_light_vertices = false;
};

using tracer::DirectLight;

const Choice kChoices[] = {
    {"light_alone", {.light_paths = false, .direct_light = DirectLight::Light}},
    {"light_alone_and_light_paths", {.direct_light = DirectLight::Light}},
    {"light_paths", {}},
    {"no_light_paths", {.light_paths = false}},
    {"selection_by_power", {.light_selection = tracer::LightSelection::Power}},
    {"light_connections", {.light_paths = false}, true},
    {"light_connections_and_light_paths", {}, true},
};

image::Image rendered(const Choice& choice, int samples, std::uint64_t seed) {
  auto world = world_of(scene_with_saddle(), choice.world);
  world.connects_light_vertices = choice.connects_light_vertices;
  const std::atomic<bool> never{false};
  return tracer::render(world, {.samples_per_pixel = samples, .seed = seed}, never,
                        [](const tracer::Progress&) {})
      .image;
}

struct Sum {
  double value = 0;
  double variance = 0;
};

Sum sum_of_quarter(const image::Image& image, int quarter, std::size_t channel) {
  Sum sum;
  for (int y = 0; y < kSide_px / 2; ++y)
    for (int x = 0; x < kSide_px / 2; ++x) {
      const int px = x + quarter % 2 * kSide_px / 2;
      const int py = y + quarter / 2 * kSide_px / 2;
      sum.value += image.at(px, py, channel);
      sum.variance += image.at(px, py, channel + 3);
    }
  return sum;
}

class PluginLamp : public testing::TestWithParam<Choice> {};

}  // namespace

// Of a saddle z = k (x^2 - y^2) in its own space the area is a double integral, here by the midpoint rule.
// Stretched evenly it is the square of the factor as large.
TEST(PluginLampDensity, IsOneOverTheAreaOnAverage) {
  constexpr int kCells = 400;
  double exact = 0;
  for (int i = 0; i < kCells; ++i)
    for (int j = 0; j < kCells; ++j) {
      const double x = kHalfSize * ((2 * i + 1.0) / kCells - 1);
      const double y = kHalfSize * ((2 * j + 1.0) / kCells - 1);
      exact += std::hypot(1, 2 * kCurvature * std::hypot(x, y));
    }
  exact *= std::pow(2 * kHalfSize / kCells, 2);
  const scene::PluginForm form{"saddle", {{"half_size", kHalfSize}, {"k", kCurvature}}};
  for (const double factor : {1.0, 3.0}) {
    const Mat4 matrix = translation({5, -2, 1}) * rotation_x(40) * scaling({factor, factor, factor});
    const auto shape = tracer::make_plugin_shape({"s", form, matrix, 0}, "s", {}, libraries());
    EXPECT_NEAR(tracer::sampled_area(shape), exact * factor * factor, 0.002 * exact * factor * factor);
  }
}

// A plane piece that a matrix stretches unevenly has an area that everybody knows: 1.2 x 0.5 times the
// square.
TEST(PluginLampDensity, FollowsUnevenMatrices) {
  const scene::PluginForm flat{"saddle", {{"half_size", kHalfSize}, {"k", 0}}};
  const Mat4 matrix = rotation_y(20) * scaling({1.2, 0.5, 7}) * rotation_z(30);
  const auto shape = tracer::make_plugin_shape({"s", flat, matrix, 0}, "s", {}, libraries());
  const double area = 1.2 * 0.5 * 4 * kHalfSize * kHalfSize;
  for (std::uint64_t i = 0; i < 100; ++i) {
    const auto point = tracer::sampled_point(shape, uniform(i, 0), uniform(i, 1));
    ASSERT_TRUE(point);
    EXPECT_NEAR(point->pdf_area * area, 1, 1e-12);
    EXPECT_NEAR(tracer::point_at(shape, point->position)->pdf_area * area, 1, 1e-9);
  }
}

// Within four standard errors for each quarter of the image and each channel.
TEST_P(PluginLamp, HasTheImageThatBsdfSamplingFinds) {
  static const auto expected = rendered(
      {"bsdf_alone", {.light_paths = false, .direct_light = DirectLight::Bsdf, .roulette = false}}, 16384, 1);
  const auto other = rendered(GetParam(), 1024, 2);
  for (int quarter = 0; quarter < 4; ++quarter)
    for (const std::size_t channel : {0U, 2U}) {
      const Sum a = sum_of_quarter(expected, quarter, channel);
      const Sum b = sum_of_quarter(other, quarter, channel);
      const double error = 4 * std::sqrt(a.variance + b.variance);
      EXPECT_NEAR(b.value, a.value, error) << "quarter " << quarter << ", channel " << channel;
      EXPECT_LT(error, 0.08 * a.value) << "quarter " << quarter;  // otherwise the test could not fail
    }
}

INSTANTIATE_TEST_SUITE_P(Saddle, PluginLamp, testing::ValuesIn(kChoices), [](const auto& choice) {
  return std::string(choice.param.name);
});
