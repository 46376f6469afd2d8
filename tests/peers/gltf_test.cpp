#include "peers/cycles_render.h"
#include "peers/scenes.h"
#include "peers/texels.h"

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

/// What is exported as glTF, as Blender's importer reads it and Cycles renders it: images whose values are
/// known in closed form. A wrong value is one of the exporter, of the importer or of Cycles.
namespace {

using namespace orbs;
using namespace orbs::peers;

image::Image rendered(const scene::Scene& scene, const std::string& name, int spp) {
  return render_with_cycles(scene, name, spp, "cycles-gltf");
}

double mean_of(const image::Image& image) {
  double sum = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) sum += value(image, x, y);
  return sum / (image.width * image.height);
}

TEST(CyclesGltf, CameraMapsEveryPixelOfANonSquareImage) {
  const auto image = rendered(tilted_camera_before_quad({5, 0.25, 1000}), "camera", 16);
  for (int y = 0; y < 24; ++y)
    for (int x = 0; x < 64; ++x) {
      const double covered = is_on_tilted_quad(x, y) ? 1 : 0;
      ASSERT_NEAR(value(image, x, y, 0), 5 * covered, 1e-5) << x << " " << y;
      ASSERT_NEAR(value(image, x, y, 1), 0.25 * covered, 1e-6) << x << " " << y;
      ASSERT_NEAR(value(image, x, y, 2), 1000 * covered, 1e-3) << x << " " << y;
    }
}

// Cycles interpolates texels of 8 bits before it decodes them. The rest is as in the test of cycles.py: the
// values of a pixel spread over at most 0.05, which 256 samples average to 9e-4 or better; four of these.
void expect_texels(const Look& look) {
  const auto decoded = [](double s) { return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4); };
  const auto image = rendered(
      texture_scene(look, std::filesystem::path(ORBS_BINARY_DIR) / "cycles-gltf tests"), look.name, 256);
  Look encoded = look;
  encoded.as_float = true;
  constexpr int kGrid = 8;
  for (int y = 0; y < kTexturePixels; ++y)
    for (int x = 0; x < kTexturePixels; ++x) {
      double expected = 0;
      for (int i = 0; i < kGrid * kGrid; ++i)
        expected +=
            decoded(texture_value(encoded, x + (i % kGrid + 0.5) / kGrid, y + (i / kGrid + 0.5) / kGrid));
      expected /= kGrid * kGrid;
      ASSERT_NEAR(value(image, x, y), expected, 3.6e-3) << look.name << " " << x << " " << y;
    }
}

TEST(CyclesGltf, TexturesLieWhereTheyShould) {
  expect_texels({.name = "turned texture",
                 .matrix = translation({0.5, -0.7, 0}) * rotation_z(30) * scaling({0.8, 0.6, 1})});
  expect_texels({.name = "sheared texture",
                 .wrap_u = scene::Wrap::Clamp,
                 .wrap_v = scene::Wrap::Clamp,
                 .matrix = {{0.8, -0.3, 0, 0.5, 0.2, 0.6, 0, -0.7, 0, 0, 1, 0, 0, 0, 0, 1}}});
}

// The left lamp shines towards the camera, the right one away from it.
TEST(CyclesGltf, LampsAreBlackFromBehind) {
  auto scene = empty_scene(16, 8, 45);
  for (const double side : {-1.0, 1.0})
    scene.lights.push_back({side < 0 ? "front" : "back",
                            scene::RectShape{0.5, 0.5},
                            {7, 3, 1},
                            translation({side, 0, -3}) * rotation_x(side * 90),
                            {}});
  const auto image = rendered(scene, "lamps", 16);
  EXPECT_NEAR(value(image, 4, 4, 0), 7, 1e-5);
  EXPECT_NEAR(value(image, 4, 4, 1), 3, 1e-5);
  EXPECT_EQ(value(image, 11, 4, 0), 0);
  EXPECT_EQ(value(image, 0, 0, 0), 0);
}

// The environment is a box that shines. A pixel's noise is larger than what is asked of their mean.
TEST(CyclesGltf, GlassIsInvisibleInAUniformEnvironment) {
  const auto image = rendered(glass_ball_in_uniform_light(64), "furnace", 256);
  EXPECT_NEAR(mean_of(image), 1, 1e-3);
}

TEST(CyclesGltf, GlassSlabTransmitsWithAllItsInterreflections) {
  EXPECT_NEAR(mean_of(rendered(glass_slab(32, 32), "slab", 256)), kSlabTransmission, 2e-3);
}

}  // namespace
