// The algorithms of the tracer that can be chosen: each has the same expected image, and what it costs in
// noise to do without one.
#include "tracer/world/build_world.h"
#include "unit/tracer/scenes.h"

#include <cmath>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using tests::scene_text;
using tracer::DirectLight;
using tracer::RenderSettings;
using tracer::Sampler;
using tracer::WorldSettings;

image::Image rendered(const scene::Scene& scene,
                      const WorldSettings& world_settings,
                      const RenderSettings& settings,
                      bool connects_light_vertices = false) {
  const std::atomic<bool> never{false};
  auto world = tracer::make_world(scene, world_settings);
  world.connects_light_vertices = connects_light_vertices;
  return tracer::render(world, settings, never, [](const tracer::Progress&) {}).image;
}

// A scene of data/bench with this width; the height follows.
scene::Scene bench_scene(const std::string& name, int width_px) {
  auto scene = scene::load_scene(ORBS_SOURCE_DIR "/data/bench/" + name);
  scene.camera.height_px = scene.camera.height_px * width_px / scene.camera.width_px;
  scene.camera.width_px = width_px;
  return scene;
}

// A floor, a ball of glass and a glossy one before a mirror; lights large enough for BSDF sampling: a
// rectangle, an emissive mesh, an emissive sphere that light sampling does not know, and a dim environment.
scene::Scene mixed_scene() {
  const auto text = scene_text("[0, 2.5, 6]", "[0, 0.7, 0]", 24, 6, R"(
    "environment": [0.05, 0.1, 0.15],
    "materials": [{"name": "floor", "type": "lambert", "reflectance": [0.7, 0.6, 0.4]},
                  {"name": "glass", "type": "glass", "colour": [1, 0.9, 1], "ior": 1.5},
                  {"name": "glossy", "type": "ggx", "colour": [0.9, 0.8, 0.7], "alpha": 0.2},
                  {"name": "mirror", "type": "mirror", "reflectance": [0.9, 0.8, 0.9]},
                  {"name": "glow", "type": "emission", "radiance": [3, 3, 3]}],
    "meshes": [{"name": "p", "generator": "plane", "half_size": 6, "material": "floor"},
               {"name": "ball", "generator": "sphere", "radius": 0.7, "segments": 24, "material": "glass"},
               {"name": "glossy-ball", "generator": "sphere", "radius": 0.7, "segments": 24, "material": "glossy"},
               {"name": "wall", "generator": "plane", "half_size": 2, "material": "mirror"},
               {"name": "lamp", "generator": "plane", "half_size": 0.6, "material": "glow"}],
    "instances": [{"mesh": "p"}, {"mesh": "ball", "matrix": [{"translate": [-0.9, 0.9, 0]}]},
                  {"mesh": "glossy-ball", "matrix": [{"translate": [0.9, 0.8, 0]}]},
                  {"mesh": "wall", "matrix": [{"translate": [0, 1.5, -2]}, {"rotate_x": 80}]},
                  {"mesh": "lamp", "matrix": [{"translate": [-1.5, 3, 0.5]}, {"rotate_x": 20}]}],
    "shapes": [{"type": "sphere", "centre": [1.8, 2.2, 0.5], "radius": 0.5, "material": "glow"}],
    "lights": [{"type": "rect", "half_width": 0.8, "half_length": 0.8, "radiance": [4, 4, 4],
                "matrix": [{"translate": [0.8, 3.2, 0.2]}]}])",
                               "40");
  return scene::load_scene_text("test.json", text, ORBS_SOURCE_DIR);
}

struct Algorithm {
  const char* name;
  WorldSettings world;
  RenderSettings render;
  bool connects_light_vertices = false;
};

const Algorithm kAlgorithms[] = {
    {"independent", {}, {.sampler = Sampler::Independent}},
    {"stratified", {}, {.sampler = Sampler::Stratified}},
    {"light_alone", {.direct_light = DirectLight::Light}, {}},
    {"light_alone_without_light_paths", {.light_paths = false, .direct_light = DirectLight::Light}, {}},
    {"bsdf_alone", {.direct_light = DirectLight::Bsdf}, {}},
    {"bsdf_alone_without_light_paths", {.light_paths = false, .direct_light = DirectLight::Bsdf}, {}},
    {"no_roulette", {.roulette = false}, {}},
    {"no_light_paths", {.light_paths = false}, {}},
    {"selection_by_power", {.light_selection = tracer::LightSelection::Power}, {}},
    {"light_connections", {}, {}, true},
    {"light_connections_without_light_paths", {.light_paths = false}, {}, true},
    {"light_connections_alone", {.light_paths = false, .mirrored_light = false}, {}, true},
    {"no_mirrored_light", {.mirrored_light = false}, {}},
    {"no_mirrored_light_and_no_light_paths", {.light_paths = false, .mirrored_light = false}, {}},
};

class TracerAlgorithm : public testing::TestWithParam<Algorithm> {};

constexpr int kSide_px = 24;

struct Sum {
  double value = 0;
  double variance = 0;
};

// Red of one quarter of the image.
Sum sum_of_quarter(const image::Image& image, int quarter) {
  Sum sum;
  for (int y = 0; y < kSide_px / 2; ++y)
    for (int x = 0; x < kSide_px / 2; ++x) {
      const int px = x + quarter % 2 * kSide_px / 2;
      const int py = y + quarter / 2 * kSide_px / 2;
      sum.value += image.at(px, py, 0);
      sum.variance += image.at(px, py, 3);
    }
  return sum;
}

// Sum over all pixels of the squared error of red, relative to the square of the expected value.
double relative_squared_error(const image::Image& image, const image::Image& expected) {
  double sum = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double truth = expected.at(x, y, 0);
      const double error = image.at(x, y, 0) - truth;
      sum += error * error / (truth * truth + 1e-4);
    }
  return sum / static_cast<double>(image.pixel_count());
}

double mean_error_over_seeds(const scene::Scene& scene,
                             const image::Image& expected,
                             const WorldSettings& world,
                             RenderSettings settings) {
  constexpr int kSeeds = 4;
  double sum = 0;
  for (settings.seed = 1; settings.seed <= kSeeds; ++settings.seed)
    sum += relative_squared_error(rendered(scene, world, settings), expected);
  return sum / kSeeds;
}

}  // namespace

// Within four standard errors for each quarter of the image.
TEST_P(TracerAlgorithm, HasTheSameExpectedImage) {
  const auto scene = mixed_scene();
  static const auto usual = rendered(scene, {}, {.samples_per_pixel = 2048, .seed = 1});
  RenderSettings settings = GetParam().render;
  settings.samples_per_pixel = 1024;
  settings.seed = 2;
  const auto other = rendered(scene, GetParam().world, settings, GetParam().connects_light_vertices);
  for (int quarter = 0; quarter < 4; ++quarter) {
    const Sum a = sum_of_quarter(usual, quarter);
    const Sum b = sum_of_quarter(other, quarter);
    const double error = 4 * std::sqrt(a.variance + b.variance);
    EXPECT_NEAR(b.value, a.value, error) << "quarter " << quarter;
    EXPECT_LT(error, 0.06 * a.value) << "quarter " << quarter;  // otherwise the test could not fail
  }
}

INSTANTIATE_TEST_SUITE_P(MixedScene,
                         TracerAlgorithm,
                         testing::ValuesIn(kAlgorithms),
                         [](const auto& algorithm) { return std::string(algorithm.param.name); });

// A bright floor between two mirrors, seen after five to fifteen reflections: all there is to roulette would
// be noise. The random numbers of both images are the same.
TEST(TracerRoulette, LeavesPathsAloneThatOnlyMirrorsHaveScattered) {
  const auto text = scene_text("[0.2, 0, 0]", "[1.2, -0.05, -0.1]", 16, 64, R"(
    "materials": [{"name": "floor", "type": "emission", "radiance": [1, 1, 1]},
                  {"name": "mirror", "type": "mirror", "reflectance": [0.9, 0.9, 0.9]}],
    "meshes": [{"name": "p", "generator": "plane", "half_size": 40, "material": "floor"},
               {"name": "wall", "generator": "plane", "half_size": 40, "material": "mirror"}],
    "instances": [{"mesh": "p", "matrix": [{"translate": [0, -1, 0]}]},
                  {"mesh": "wall", "matrix": [{"translate": [1, 0, 0]}, {"rotate_z": 90}]},
                  {"mesh": "wall", "matrix": [{"translate": [-1, 0, 0]}, {"rotate_z": -90}]}])",
                               "2");
  const auto scene = scene::load_scene_text("test.json", text, ORBS_SOURCE_DIR);
  const auto with = rendered(scene, {}, {.samples_per_pixel = 4});
  EXPECT_GT(with.at(8, 8, 0), 0.1F);
  EXPECT_LT(with.at(8, 8, 0), 0.6F);
  EXPECT_EQ(with.pixels, rendered(scene, {.roulette = false}, {.samples_per_pixel = 4}).pixels);
}

// Large lights in smooth plates are found by BSDF sampling, small ones in rough plates by light sampling, and
// both by their combination (Veach 1997, fig. 9.2).
TEST(TracerDirectLightChoice, MisHasLessNoiseThanEitherHalf) {
  const auto scene = bench_scene("veach-plates.json", 32);
  const auto settings_with = [](DirectLight direct_light) {
    return WorldSettings{.light_paths = false, .direct_light = direct_light};
  };
  const auto expected =
      rendered(scene, settings_with(DirectLight::Mis), {.samples_per_pixel = 1024, .seed = 9});
  const auto error_with = [&](DirectLight direct_light) {
    return mean_error_over_seeds(scene, expected, settings_with(direct_light), {.samples_per_pixel = 64});
  };
  const double mis = error_with(DirectLight::Mis);
  const double light = error_with(DirectLight::Light);
  const double bsdf = error_with(DirectLight::Bsdf);
  RecordProperty("relMSE", fmt::format("mis {:.4g} light {:.4g} bsdf {:.4g}", mis, light, bsdf));
  EXPECT_LT(mis, 0.7 * light);
  EXPECT_LT(mis, 0.1 * bsdf);
}

// The slope of the mean squared error against the number of samples, between 16 and 256: -1 for independent
// samples. Where the integrand is smooth, scrambled Sobol' points reach -3 in one dimension (Owen 1997), and
// here, in four, better than -1.5. Strata of pairs lie between.
TEST(TracerSampler, OwenScrambledSobolPointsConvergeFasterOnASmoothIntegrand) {
  const auto scene = bench_scene("smooth-floor.json", 16);
  const auto expected = rendered(scene, {}, {.samples_per_pixel = 1 << 14, .seed = 9});
  const auto error_of = [&](Sampler sampler, int spp) {
    return mean_error_over_seeds(scene, expected, {}, {.samples_per_pixel = spp, .sampler = sampler});
  };
  const auto slope_of = [&](Sampler sampler) {
    return std::log(error_of(sampler, 256) / error_of(sampler, 16)) / std::log(256.0 / 16);
  };
  const double independent = slope_of(Sampler::Independent);
  const double stratified = slope_of(Sampler::Stratified);
  const double sobol = slope_of(Sampler::Sobol);
  RecordProperty("slopes", fmt::format("independent {:.2f} stratified {:.2f} sobol {:.2f}", independent,
                                       stratified, sobol));
  EXPECT_NEAR(independent, -1, 0.1);
  EXPECT_LT(stratified, -1.1);
  EXPECT_LT(sobol, -1.5);
}
