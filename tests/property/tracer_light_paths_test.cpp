// Light paths against camera paths alone, and against mirrored light sampling.
#include "scene/load/load_scene.h"
#include "tracer/choose_light.h"
#include "tracer/world/build_world.h"
#include "unit/tracer/scenes.h"

#include <numbers>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using tests::error_of_mean;
using tests::mean_of_channel;
using tests::scene_text;

tracer::World world_of(const std::string& text, bool light_paths) {
  return tracer::make_world(scene::load_scene_text("test.json", text, ORBS_SOURCE_DIR),
                            {.light_paths = light_paths, .mirrored_light = light_paths});
}

image::Image rendered(const tracer::World& world, const tracer::RenderSettings& settings) {
  const std::atomic<bool> never{false};
  return tracer::render(world, settings, never, [](const tracer::Progress&) {}).image;
}

const char* const kRectLight =
    R"({"type": "rect", "half_width": 0.3, "half_length": 0.3, "radiance": [8, 8, 8], "matrix": [{"translate": [0.5, 3, 0.2]}]})";

// A floor and a ball of `material` above it, both visible.
std::string ball_over_floor(const std::string& material, const std::string& light) {
  return scene_text("[0, 2.5, 6]", "[0, 0.7, 0]", 24, 6,
                    R"("materials": [{"name": "floor", "type": "lambert", "reflectance": [0.8, 0.6, 0.4]},
                                     {"name": "ball", )" +
                        material + R"(}, {"name": "glow", "type": "emission", "radiance": [6, 6, 6]},
                                     {"name": "wall", "type": "mirror", "reflectance": [0.9, 0.8, 0.9]}],
                       "meshes": [{"name": "p", "generator": "plane", "half_size": 6, "material": "floor"},
                                  {"name": "s", "generator": "sphere", "radius": 0.8, "segments": 24, "material": "ball"},
                                  {"name": "flat", "generator": "plane", "half_size": 2, "material": "ball"},
                                  {"name": "cube", "generator": "cube", "half_size": 0.5, "material": "ball"},
                                  {"name": "lamp", "generator": "plane", "half_size": 0.3, "material": "glow"}],
                       "instances": [{"mesh": "p"}, {"mesh": "s", "matrix": [{"translate": [0, 1, 0]}]})" +
                        light,
                    "40");
}

std::string with_light(const std::string& light) { return "], \"lights\": [" + light + "]"; }

const char* const kGlass = R"("type": "glass", "colour": [1, 0.9, 1], "ior": 1.5)";

const char* const kMirror = R"("type": "mirror", "reflectance": [0.9, 0.8, 0.9])";
const std::string kWall =
    R"(, {"mesh": "flat", "matrix": [{"translate": [-1.5, 1.5, 0]}, {"rotate_z": 80}]})";
const std::string kMirrorWall =
    R"(, {"mesh": "flat", "matrix": [{"translate": [-1.5, 1.5, 0]}, {"rotate_z": 80}], "remap": ["ball", "wall"]})";
const std::string kCube =
    R"(, {"mesh": "cube", "matrix": [{"translate": [1.6, 0.8, 0.5]}, {"rotate_x": 25}, {"rotate_y": 40}]})" +
    kWall;

struct Scene {
  const char* name;
  std::string text;
};

// The glass ball and a flat mirror beside it, seen by another camera.
std::string seen_by(const std::string& keys) {
  auto text = ball_over_floor(kGlass, kMirrorWall + with_light(kRectLight));
  return text.replace(text.find("\"fov_y\": 40"), 11, keys);
}

std::vector<Scene> caustic_scenes() {
  return {
      {"lens", seen_by(R"("fov_y": 40, "focus_distance": 4, "aperture_radius": 0.4)")},
      {"shifted", seen_by(R"("fov_y": 40, "shift": [0.2, -0.1])")},
      {"orthographic", seen_by(R"("projection": "orthographic", "view_height": 5)")},
      {"mirror",
       ball_over_floor(R"("type": "mirror", "reflectance": [0.9, 0.9, 0.9])", with_light(kRectLight))},
      {"glass", ball_over_floor(kGlass, with_light(kRectLight))},
      {"glossy",
       ball_over_floor(R"("type": "ggx", "colour": [0.9, 0.8, 0.7], "alpha": 0.1)", with_light(kRectLight))},
      {"rough_glass",
       ball_over_floor(R"("type": "rough_glass", "colour": [1, 1, 1], "ior": 1.5, "alpha": 0.1)",
                       with_light(kRectLight))},
      {"disk", ball_over_floor(kGlass, with_light(R"({"type": "disk", "radius": 0.4, "radiance": [8, 8, 8],
          "matrix": [{"translate": [0.5, 3, 0.2]}, {"scale": [1, 1, 0.5]}]})"))},
      {"ellipsoid",
       ball_over_floor(kGlass, with_light(R"({"type": "sphere", "radius": 0.3, "radiance": [8, 8, 8],
          "matrix": [{"translate": [0.5, 3, 0.2]}, {"rotate_x": 30}, {"scale": [1, 2, 0.5]}]})"))},
      {"emissive_mesh",
       ball_over_floor(kGlass,
                       R"(, {"mesh": "lamp", "matrix": [{"translate": [0.5, 3, 0.2]}, {"rotate_x": 20}]}])")},
      {"flat_mirror", ball_over_floor(kMirror, kWall + with_light(kRectLight))},
      {"mirror_cube", ball_over_floor(kMirror, kCube + with_light(kRectLight))},
      {"glossy_wall_and_cube", ball_over_floor(R"("type": "ggx", "colour": [0.9, 0.8, 0.7], "alpha": 0.1)",
                                               kCube + with_light(kRectLight))},
      {"mirror_wall_emissive_mesh",
       ball_over_floor(
           kMirror,
           kWall + R"(, {"mesh": "lamp", "matrix": [{"translate": [0.5, 3, 0.2]}, {"rotate_x": 20}]}])")},
      {"emissive_ball",
       ball_over_floor(kGlass, R"(], "shapes": [{"type": "sphere", "centre": [0.5, 3, 0.2], "radius": 0.4,
          "material": "glow"}])" + with_light(kRectLight).substr(1))},
      {"lamp_inside",
       ball_over_floor(kGlass, with_light(R"({"type": "sphere", "radius": 0.2, "radiance": [8, 8, 8],
          "matrix": [{"translate": [0, 1, 0]}]})"))},
  };
}

class TracerCaustics : public testing::TestWithParam<Scene> {};

}  // namespace

// Within four standard errors for each quarter of the image. Few camera paths find a caustic, so that one
// render states too little noise now and then; the mean of four states what is usual.
TEST_P(TracerCaustics, AreTheSameFromTheLightAndFromTheCamera) {
  constexpr int kRenders = 4;
  const auto with_world = world_of(GetParam().text, true);
  const auto without_world = world_of(GetParam().text, false);
  ASSERT_FALSE(with_world.caustic_casters.empty());
  std::array<double, 4> difference{};
  std::array<double, 4> variance{};
  for (std::uint64_t seed = 1; seed <= kRenders; ++seed) {
    const auto with = rendered(with_world, {.samples_per_pixel = 64, .seed = seed});
    const auto without = rendered(without_world, {.samples_per_pixel = 1024, .seed = 100 + seed});
    const auto channels = with.channel_count();
    for (std::size_t i = 0; i < with.pixel_count(); ++i) {
      const std::size_t quarter = i / (24 * 12) * 2 + i % 24 / 12;
      difference.at(quarter) += with.pixels[i * channels] - without.pixels[i * channels];
      variance.at(quarter) += with.pixels[i * channels + 3] + without.pixels[i * channels + 3];
    }
  }
  for (std::size_t quarter = 0; quarter < 4; ++quarter)
    EXPECT_NEAR(difference.at(quarter), 0, 4 * std::sqrt(variance.at(quarter))) << "quarter " << quarter;
}

INSTANTIATE_TEST_SUITE_P(Scenes, TracerCaustics, testing::ValuesIn(caustic_scenes()), [](const auto& scene) {
  return std::string(scene.param.name);
});

TEST(TracerLightPaths, AreNotTracedToALatitudeLongitudeImage) {
  const auto world = world_of(seen_by(R"("projection": "latitude_longitude")"), true);
  EXPECT_TRUE(world.caustic_casters.empty());
  EXPECT_NE(tracer::why_no_light_paths(world).find("latitude-longitude"), std::string::npos);
}

// From straight above, a glossy floor shows the ball beside it by the tail of its lobe alone. Light counted
// twice would double it; the tolerance is four standard errors of eight seeds.
TEST(TracerLightPaths, BringTheTailsOfGlossyLobesOnce) {
  const auto world_from = [](bool light_paths) {
    return world_of(
        scene_text("[1.8, 4, 0]", "[1.8, 0, 0]", 16, 6,
                   R"("materials": [{"name": "floor", "type": "ggx", "colour": [1, 1, 1], "alpha": 0.15},
                                    {"name": "ball", "type": "ggx", "colour": [1, 1, 1], "alpha": 0.29}],
                      "meshes": [{"name": "p", "generator": "plane", "half_size": 6, "material": "floor"},
                                 {"name": "s", "generator": "sphere", "radius": 0.8, "segments": 24, "material": "ball"}],
                      "instances": [{"mesh": "p"}, {"mesh": "s", "matrix": [{"translate": [0, 1, 0]}]})" +
                       with_light(kRectLight),
                   "20"),
        light_paths);
  };
  const auto light_of = [](const tracer::World& world, std::uint64_t seed) {
    const std::atomic<bool> never{false};
    const auto image = tracer::render(world, {.samples_per_pixel = 1024, .seed = seed, .split_paths = true},
                                      never, [](const tracer::Progress&) {})
                           .image;
    return mean_of_channel(image, static_cast<std::size_t>(image::channel_index(image, "path.EGGL.R")));
  };
  const auto with_light_paths = world_from(true);
  const auto without = world_from(false);
  constexpr int kSeeds = 8;
  double expected = 0;
  double sum = 0;
  double squares = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const double from_camera = light_of(without, 100 + seed);
    const double difference = light_of(with_light_paths, seed) - from_camera;
    expected += from_camera / kSeeds;
    sum += difference;
    squares += difference * difference;
  }
  const double mean = sum / kSeeds;
  const double error = std::sqrt((squares / kSeeds - mean * mean) / (kSeeds - 1));
  EXPECT_NEAR(mean, 0, 4 * error);
  EXPECT_LT(4 * error, 0.2 * expected);  // otherwise the test could not fail
}

// A flat mirror adds to a floor what a light at its mirror image would add.
TEST(TracerLightPaths, AFlatMirrorIlluminatesLikeTheMirroredLight) {
  const auto scene = [](const std::string& mirror, const std::string& lamp_x, const std::string& turn) {
    return scene_text("[0.7, 4, 0.3]", "[1, 0, 0]", 8, 2,
                      R"("materials": [{"name": "floor", "type": "lambert", "reflectance": [0.5, 0.5, 0.5]},
                          {"name": "mirror", "type": "mirror", "reflectance": [1, 1, 1]}],
                         "meshes": [{"name": "p", "generator": "plane", "half_size": 20, "material": "floor"},
                          {"name": "m", "generator": "plane", "half_size": 20, "material": "mirror"}],
                         "instances": [{"mesh": "p"})" +
                          mirror + R"(], "lights": [{"type": "rect", "half_width": 0.2, "half_length": 0.2,
                          "radiance": [50, 50, 50], "matrix": [{"translate": [)" +
                          lamp_x + R"(, 2, 0]}, {"rotate_z": )" + turn + "}]}]",
                      "20");
  };
  // The light faces the mirror at x = -1 and illuminates the floor by it alone.
  const std::string mirror = R"(, {"mesh": "m", "matrix": [{"translate": [-1, 0, 0]}, {"rotate_z": 90}]})";
  const auto world = world_of(scene(mirror, "0", "-60"), true);
  ASSERT_FALSE(world.caustic_casters.empty());
  const std::atomic<bool> never{false};
  const auto seen = tracer::render(world, {.samples_per_pixel = 1024, .split_paths = true}, never,
                                   [](const tracer::Progress&) {})
                        .image;
  const auto channel =
      std::find(seen.channels.begin(), seen.channels.end(), "path.EDSL.R") - seen.channels.begin();
  ASSERT_LT(channel, static_cast<std::ptrdiff_t>(seen.channel_count()));
  const auto image_of_light = rendered(world_of(scene("", "-2", "60"), false), {.samples_per_pixel = 64});
  const double expected = mean_of_channel(image_of_light, 0);
  EXPECT_GT(expected, 0.01);
  EXPECT_NEAR(mean_of_channel(seen, static_cast<std::size_t>(channel)), expected,
              4 * error_of_mean(seen, 0) + 1e-3 * expected);
}

TEST(TracerLightPaths, DoNotDependOnTheThreads) {
  const auto world = world_of(caustic_scenes()[1].text, true);
  const auto one = rendered(world, {.samples_per_pixel = 8, .threads = 1});
  EXPECT_EQ(one.pixels, rendered(world, {.samples_per_pixel = 8, .threads = 3}).pixels);
}

namespace {

// By the trials of an image of 4096 samples per pixel.
bool are_light_paths_chosen(tracer::World& world) {
  tracer::choose_light(world, {.samples_per_pixel = 4096}, {.selection = false, .connections = false});
  return !world.caustic_casters.empty();
}

}  // namespace

TEST(TracerLightPaths, AreChosenWhereTheyLowerTheNoise) {
  auto caustic = world_of(caustic_scenes()[0].text, true);
  EXPECT_TRUE(are_light_paths_chosen(caustic));
  auto plain = world_of(
      ball_over_floor(R"("type": "lambert", "reflectance": [0.9, 0.9, 0.9])", with_light(kRectLight)), true);
  EXPECT_FALSE(are_light_paths_chosen(plain));
}

// Camera paths hit the light about once in a million samples, so that their trial shows a shadowed floor
// without noise, or a firefly as bright as the missing caustic.
TEST(TracerLightPaths, AreChosenWhereCameraPathsHardlyEverFindTheCaustic) {
  auto world = world_of(
      ball_over_floor(
          kGlass,
          with_light(
              R"({"type": "rect", "half_width": 0.005, "half_length": 0.005, "radiance": [30000, 30000, 30000],
                  "matrix": [{"translate": [0, 5, 0]}]})")),
      true);
  EXPECT_TRUE(are_light_paths_chosen(world));
}

// The only light comes through a slit and a prism, and no camera path of a trial finds it.
TEST(TracerLightPaths, AreChosenWhereCameraPathsFindNoLightAtAll) {
  auto scene = scene::load_scene(ORBS_SOURCE_DIR "/data/cases/appearance/e6_dispersion/prism_SF10.json");
  scene.camera.width_px = scene.camera.height_px = 80;
  auto world = tracer::make_world(scene, {.light_paths = true});
  tracer::choose_light(world, {.samples_per_pixel = 16}, {.selection = false, .connections = false});
  EXPECT_FALSE(world.caustic_casters.empty());
}

// Images of 16 x 16 px have no trial, or one that meets no caustic, which is most of their light.
TEST(TracerLightPaths, AreChosenWhereATrialCannotTell) {
  for (const char* name : {"caustic_diamond_achromatic", "caustic_diamond"})
    for (const int spp : {8, 16, 64, 512}) {
      auto scene = scene::load_scene(std::string(ORBS_SOURCE_DIR "/data/cases/appearance/e6_dispersion/") +
                                     name + ".json");
      scene.camera.width_px = scene.camera.height_px = 16;
      auto world = tracer::make_world(scene, {.light_paths = true});
      tracer::choose_light(world, {.samples_per_pixel = spp}, {.selection = false, .connections = false});
      EXPECT_FALSE(world.caustic_casters.empty()) << name << ", " << spp;
    }
}

TEST(TracerLightPaths, AreNotChosenForAGlimpseThatTheyHardlyHit) {
  auto text = caustic_scenes()[0].text;
  const std::string fov = R"("fov_y": 40)";
  text.replace(text.find(fov), fov.size(), R"("fov_y": 0.05)");
  auto world = world_of(text, true);
  EXPECT_FALSE(are_light_paths_chosen(world));
}

// The pdf of a mixture of cones is one over their joint solid angle if they do not overlap; the mean of 1 /
// pdf is that solid angle in any case.
TEST(CausticCasters, SampledDirectionsFillTheConesOfAllCasters) {
  const std::vector<tracer::BoundingSphere> targets{{{0, 0, 5}, 1}, {{5, 0, 0}, 2}};
  const auto cone = [](double sine) { return 2 * std::numbers::pi * (1 - std::sqrt(1 - sine * sine)); };
  double sum = 0;
  constexpr int kSide = 64;
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j) {
      const float pick = i % 2 == 0 ? 0.25F : 0.75F;
      const auto to = tracer::sample_towards_casters(targets, {}, {0, 1, 0}, pick,
                                                     (static_cast<float>(i / 2) + 0.5F) / (kSide / 2),
                                                     (static_cast<float>(j) + 0.5F) / kSide);
      ASSERT_GT(to.pdf, 0);
      sum += 1 / static_cast<double>(to.pdf);
    }
  EXPECT_NEAR(sum / (kSide * kSide), cone(1.0 / 5) + cone(2.0 / 5), 1e-4);
}
