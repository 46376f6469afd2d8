#include "image/image_io.h"
#include "peers/cycles_render.h"
#include "peers/scenes.h"
#include "peers/texels.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

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

// Five squares side by side before the camera, 10 px each, which a far ball lights.
struct Cards {
  static constexpr double kAlbedo = 0.5;
  static constexpr double kDistance_m = 200;
  static constexpr double kRadius_m = 10;
  static constexpr double kRadiance = 400;
  static constexpr double kSide_m = 2.1;  // 10 m before a camera of 12 degrees
  static constexpr int kCount = 5;
  static Vec3d towards_light() { return normalised(Vec3d{0.5, 0.6, 1}); }
  static Vec3d centre(int card) { return {kSide_m * (card - 2), 0, -10}; }
};

scene::Mesh card(int place, const std::vector<Vec2f>& uvs) {
  auto mesh =
      quad(Cards::centre(place) - Vec3d{Cards::kSide_m / 2, 1.5, 0}, {Cards::kSide_m, 0, 0}, {0, 3, 0});
  mesh.uvs = uvs;
  return mesh;
}

// As they are, with u mirrored, turned by a quarter, as an instance that a matrix mirrors, and with the map
// at the second coordinates.
scene::Scene cards_with_normal_map() {
  auto scene = empty_scene(10 * Cards::kCount, 10, 12);
  scene.textures = {{"t", std::filesystem::path(ORBS_SOURCE_DIR) / "data/common/textures/tilted_normal.png"}};
  scene.textures[0].encoding = scene::Encoding::Linear;
  constexpr double kL = Cards::kRadiance;
  scene.lights = {{"ball",
                   scene::SphereShape{Cards::kRadius_m},
                   {kL, kL, kL},
                   translation(Cards::towards_light() * Cards::kDistance_m),
                   {}}};
  constexpr double kRho = Cards::kAlbedo;
  for (const int uv_set : {0, 1}) {
    add_material(scene, scene::Lambert{{kRho, kRho, kRho}, {}});
    scene.materials.back().detail.normal_map = scene::NormalMap{{0, {}, uv_set}, 1};
  }
  const std::vector<Vec2f> upright{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const std::vector<Vec2f> mirrored{{1, 0}, {0, 0}, {0, 1}, {1, 1}};
  add_instance(scene, card(0, upright), 0);
  add_instance(scene, card(1, mirrored), 0);
  add_instance(scene, card(2, {{0, 1}, {0, 0}, {1, 0}, {1, 1}}), 0);
  add_instance(scene, card(1, upright), 0, scaling({-1, 1, 1}));
  auto second = card(4, upright);
  second.second_uvs = mirrored;
  add_instance(scene, second, 1);
  return scene;
}

// Albedo x radiance x (radius / distance)^2 x cosine, and less where a normal is turned towards the light
// (Chiang et al. 2019, "Taming the shadow terminator"): Cycles has no option without that.
double shown_by_cycles(int card, Vec3d normal) {
  const Vec3d way = Cards::towards_light() * Cards::kDistance_m - Cards::centre(card);
  const Vec3d to_light = normalised(way);
  const double g = std::min(1.0, to_light.z / (dot(normal, to_light) * normal.z));
  return Cards::kAlbedo * Cards::kRadiance * Cards::kRadius_m * Cards::kRadius_m / dot(way, way) *
         dot(normal, to_light) * (-g * g * g + g * g + g);
}

// Disney's diffuse reflection, which the importer makes of Lambert's, differs by at most 1.1 %; a normal that
// leans to another side by a tenth and more.
TEST(CyclesGltf, NormalMapsLeanWhereTheyShould) {
  const auto scene = cards_with_normal_map();
  const image::Image map = image::read_image(scene.textures[0].file);
  const auto component = [&](std::size_t c) { return 2 * double{map.at(0, 0, c)} - 1; };
  const Vec3d n = normalised(Vec3d{component(0), component(1), component(2)});  // along u, v and +Z
  const Vec3d mirrored{-n.x, n.y, n.z};
  const std::vector<Vec3d> normals{n, mirrored, {-n.y, n.x, n.z}, mirrored, mirrored};
  const auto image = rendered(scene, "normal maps", 4096);
  for (int i = 0; i < Cards::kCount; ++i) {
    double mean = 0;
    for (int y = 3; y < 7; ++y)
      for (int x = 10 * i + 3; x < 10 * i + 7; ++x) mean += value(image, x, y) / 16;
    const double expected = shown_by_cycles(i, normals.at(static_cast<std::size_t>(i)));
    EXPECT_NEAR(mean, expected, 0.015 * expected) << i;
  }
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
