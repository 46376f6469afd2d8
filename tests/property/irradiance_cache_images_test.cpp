// Images with an irradiance cache: furnaces, the same bytes for every number of threads, and path tracing.
#include "property/light_images.h"
#include "scene/load/load_scene.h"

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

using namespace orbs;

namespace {

constexpr const char* kCases = "data/cases/integrators/i2_irradiance_cache";

scene::Scene case_scene(const std::string& name, int side) {
  auto scene =
      scene::load_scene(std::filesystem::path(ORBS_SOURCE_DIR) / kCases / fmt::format("{}.json", name));
  scene.camera.width_px = side;
  scene.camera.height_px = side;
  return scene;
}

tracer::Rendering render_scene(const scene::Scene& scene,
                               const tracer::RenderSettings& settings,
                               const tracer::WorldSettings& world = {}) {
  const std::atomic<bool> never{false};
  return tracer::render(tracer::make_world(scene, world), settings, never, [](const tracer::Progress&) {});
}

// Largest difference between the means over tiles of 8 x 8 pixels, relative to the mean of the reference.
double largest_tile_error(const image::Image& image, const image::Image& reference) {
  constexpr int kTile = 8;
  double largest = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double mean = tests::mean_of_channel(reference, c);
    for (int y = 0; y < image.height; y += kTile)
      for (int x = 0; x < image.width; x += kTile) {
        double sum = 0;
        for (int i = 0; i < kTile * kTile; ++i)
          sum += static_cast<double>(image.at(x + i % kTile, y + i / kTile, c)) -
                 static_cast<double>(reference.at(x + i % kTile, y + i / kTile, c));
        largest = std::max(largest, std::abs(sum) / (kTile * kTile * mean));
      }
  }
  return largest;
}

// A cube of lights that shine inwards and reflect: the radiance is 1 + 0.5 + ... with one term for each
// scattering and one for the emission, wherever the camera looks.
std::string furnace(const std::string& integrator) {
  std::string lights;
  for (const char* turn : {R"({"rotate_x": 0})", R"({"rotate_x": 90})", R"({"rotate_x": 180})",
                           R"({"rotate_x": 270})", R"({"rotate_z": 90})", R"({"rotate_z": 270})"})
    lights += fmt::format(R"({}{{"type": "rect", "half_width": 1, "half_length": 1, "radiance": [1, 2, 3],
      "reflectance": [0.5, 0.5, 0.5], "matrix": [{}, {{"translate": [0, 1, 0]}}]}})",
                          lights.empty() ? "" : ", ", turn);
  return fmt::format(
      R"({{"format": "orbs-scene/1", "name": "furnace", "camera": {{"position": [0.1, 0.2, 0.3], "look_at":
      [1, 0.5, 0], "fov_y": 70, "width": 16, "height": 16}}, "materials": [], "lights": [{}],
      "integrator": {}}})",
      lights, integrator);
}

}  // namespace

// Every path finds the same light by BSDF sampling without roulette, so that nothing but rounding is left.
TEST(IrradianceCacheImages, FurnaceHasItsClosedForm) {
  const auto image = tests::image_of(
      furnace(R"({"type": "irradiance_cache", "trace_depth": 12, "rays": 64})"), 4,
      {.mirrored_light = false, .direct_light = tracer::DirectLight::Bsdf, .roulette = false});
  const double expected = 2 * (1 - std::pow(0.5, 13));  // 1 / (1 - 0.5), less what 12 scatterings leave
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        ASSERT_NEAR(image.at(x, y, c) / (static_cast<double>(c) + 1), expected, 1e-5) << x << ", " << y;
}

TEST(IrradianceCacheImages, DoNotDependOnThreads) {
  const auto scene = case_scene("i2-bleeding", 40);
  const auto one = render_scene(scene, {.samples_per_pixel = 4, .threads = 1});
  for (const int threads : {2, 5}) {
    const auto more = render_scene(scene, {.samples_per_pixel = 4, .threads = threads});
    EXPECT_EQ(one.image.pixels, more.image.pixels) << threads;
    EXPECT_EQ(one.cache_use.records, more.cache_use.records);
    EXPECT_EQ(one.cache_use.uncovered, more.cache_use.uncovered);
  }
  EXPECT_NE(one.image.pixels, render_scene(scene, {.samples_per_pixel = 4, .seed = 2}).image.pixels);
}

// What two renders of a pixel differ by is no measure of what both interpolate between the same records.
TEST(IrradianceCacheImages, StateNoVariance) {
  const auto rendering = render_scene(case_scene("i2-bleeding", 16), {.samples_per_pixel = 4});
  EXPECT_EQ(rendering.image.channel_count(), 3U);
  EXPECT_GT(rendering.cache_use.records, 0U);
  // So few pixels are large: an eighth of the samples lies where no record reaches.
  EXPECT_GT(rendering.cache_use.lookups, rendering.cache_use.uncovered * 4);
}

// The same light as by path tracing, but for the bias of interpolation: 5 % in any tile of 8 x 8 pixels, and
// less than 1 % in the mean.
TEST(IrradianceCacheImages, HaveTheLightOfPathTracing) {
  for (const char* name : {"i2-bleeding", "i2-corner"}) {
    auto scene =
        case_scene(name, 64);  // the least spacing of records is in pixels, and 32 of them are coarse
    const auto cached = render_scene(scene, {.samples_per_pixel = 256}).image;
    scene.integrator = scene::PathTracing{};
    const auto traced = render_scene(scene, {.samples_per_pixel = 2048}).image;
    EXPECT_LT(largest_tile_error(cached, traced), 0.05) << name;
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(tests::mean_of_channel(cached, c) / tests::mean_of_channel(traced, c), 1, 0.01) << name;
  }
}

namespace {

// A floor and a red wall under a lamp, half of them seen in a mirror; a sphere of glass lies before it.
std::string mirror_room(const std::string& integrator) {
  return fmt::format(R"({{"format": "orbs-scene/1", "name": "mirrors", "camera": {{"position": [0, 1, 4],
 "look_at": [0, 0.7, 0], "fov_y": 40, "width": 32, "height": 32}},
 "materials": [{{"name": "white", "type": "lambert", "reflectance": [0.8, 0.8, 0.8]}},
  {{"name": "red", "type": "lambert", "reflectance": [0.8, 0.1, 0.1]}},
  {{"name": "mirror", "type": "mirror", "reflectance": [0.9, 0.9, 0.9]}},
  {{"name": "glass", "type": "glass", "ior": 1.5}}],
 {},
 "shapes": [{{"type": "sphere", "centre": [0.6, 0.4, 0.8], "radius": 0.4, "material": "glass"}}],
 "lights": [{{"type": "rect", "half_width": 0.5, "half_length": 0.5, "radiance": [8, 8, 8],
  "matrix": [{{"translate": [0, 2.5, 1]}}]}}],
 "integrator": {}}})",
                     tests::meshes({tests::square({0, 0, 0}, {0, 1, 0}, 2, "white"),
                                    tests::square({-1.5, 0.9, 0.01}, {1, 0, 0}, 0.9, "red"),
                                    tests::square({0.2, 0.95, -0.5}, {0, 0, 1}, 0.9, "mirror")}),
                     integrator);
}

}  // namespace

// Light that the mirror throws on the floor is sampled, light of surfaces seen in it comes from the cache:
// none is counted twice or lost.
TEST(IrradianceCacheImages, FollowMirrorsAndGlass) {
  const auto cached = tests::image_of(mirror_room(R"({"type": "irradiance_cache", "trace_depth": 5})"), 256);
  const auto traced = tests::image_of(mirror_room(R"({"trace_depth": 5})"), 2048);
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(tests::mean_of_channel(cached, c) / tests::mean_of_channel(traced, c), 1, 0.01) << c;
}

// The cache of direct light alone would be empty: the image is that of path tracing to the bit.
TEST(IrradianceCacheImages, ArePathTracedAtDepthOne) {
  auto scene = case_scene("i2-bleeding", 24);
  scene.trace_depth = 1;
  const auto cached = render_scene(scene, {.samples_per_pixel = 8});
  EXPECT_EQ(cached.cache_use.records, 0U);
  scene.integrator = scene::PathTracing{};
  const auto traced = render_scene(scene, {.samples_per_pixel = 8}, {.light_paths = false}).image;
  for (int y = 0; y < 24; ++y)
    for (int x = 0; x < 24; ++x)
      for (std::size_t c = 0; c < 3; ++c) ASSERT_EQ(cached.image.at(x, y, c), traced.at(x, y, c));
}
