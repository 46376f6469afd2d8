#include "peers/cycles_render.h"
#include "peers/scenes.h"
#include "peers/texels.h"
#include "scene/geometry/generators.h"
#include "scene/relations/motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

/// The adapter on the real Cycles: images whose values are known in closed form.
namespace {

using namespace orbs;
using namespace orbs::peers;

// Ratio of image and expectation over the pixels of a rectangle: its mean, and the standard error of that
// from the scatter of the pixels, which have independent samples.
struct Ratio {
  double mean = 0;
  double error = 0;
};

using Expected = std::function<double(int, int)>;

Ratio ratio_in(const image::Image& image, const Expected& expected, int x0, int y0, int x1, int y1) {
  double sum = 0;
  double squares = 0;
  const double count = static_cast<double>(x1 - x0) * (y1 - y0);
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) {
      const double ratio = value(image, x, y) / expected(x, y);
      sum += ratio;
      squares += ratio * ratio;
    }
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean) / count)};
}

// In each quarter of the image, so that a gradient or a turn shows: four standard errors, a false alarm in
// one of 16 000 seeds, and the seed is fixed; and `bias`, what float arithmetic and tessellation may cost.
void expect_in_quarters(const image::Image& image, const Expected& expected, double bias) {
  const int half_w = image.width / 2;
  const int half_h = image.height / 2;
  for (const int x : {0, half_w})
    for (const int y : {0, half_h}) {
      const auto ratio = ratio_in(image, expected, x, y, x + half_w, y + half_h);
      EXPECT_NEAR(ratio.mean, 1, 4 * ratio.error + bias) << "quarter at " << x << ", " << y;
      EXPECT_LT(ratio.error, 2e-3) << "too noisy to say anything";
    }
}

TEST(Cycles, CameraMapsEveryPixelOfANonSquareImage) {
  const auto scene = tilted_camera_before_quad({5, 0.25, 1000});
  const auto image = render_with_cycles(scene, "camera", 16);
  for (int y = 0; y < 24; ++y)
    for (int x = 0; x < 64; ++x) {
      const double covered = is_on_tilted_quad(x, y) ? 1 : 0;
      ASSERT_EQ(value(image, x, y, 0), 5 * covered) << x << " " << y;
      ASSERT_EQ(value(image, x, y, 1), 0.25 * covered) << x << " " << y;
      ASSERT_EQ(value(image, x, y, 2), 1000 * covered) << x << " " << y;  // nothing is clamped
    }
}

TEST(Cycles, RectGivesItsFormFactor) {
  auto scene = floor_scene();
  const Mat4 matrix = translation({0.3, 1.5, -0.2}) * rotation_x(30) * rotation_y(20) * rotation_z(-15) *
                      scaling({2, 1, 0.5});
  scene.lights.push_back({"l", scene::RectShape{0.25, 0.5}, {3, 3, 3}, matrix, {}});
  std::array<Vec3d, 4> corners{{{-0.25, 0, -0.5}, {0.25, 0, -0.5}, {0.25, 0, 0.5}, {-0.25, 0, 0.5}}};
  for (auto& corner : corners) corner = transform_point(matrix, corner);
  const auto image = render_with_cycles(scene, "rect", 512);
  const auto expected = [&](int x, int y) {
    return kFloorAlbedo * 3 * polygon_factor(floor_point(scene, x, y), corners);
  };
  expect_in_quarters(image, expected, 1e-3);
}

// Cycles' own constants are lengths in metres, and Blender's cameras clip nearer than a micrometre.
TEST(Cycles, AWorldOfAnySizeLooksTheSame) {
  auto scene = floor_scene();
  scene.lights.push_back({"l", scene::RectShape{0.25, 0.5}, {3, 3, 3}, translation({0.3, 1.5, -0.2}), {}});
  const auto usual = render_with_cycles(scene, "metres", 64);
  for (const double factor : {1e-8, 1e8}) {
    const auto image =
        render_with_cycles(scene::moved(scene, scaling({factor, factor, factor})), "scaled", 64);
    // The same random numbers on coordinates that are rounded elsewhere; without the adapter's help the image
    // of the small world is black.
    double most = 0;
    for (int y = 0; y < usual.height; ++y)
      for (int x = 0; x < usual.width; ++x)
        most = std::max(most, std::abs(value(image, x, y) / value(usual, x, y) - 1));
    EXPECT_LT(most, 0.01) << factor;
  }
}

// Wholly above the horizon: F = (r / d)^2 cos. The adapter's sphere is an icosahedron's subdivision of the
// same surface, which is 5e-4 too dark here.
TEST(Cycles, SphereGivesItsFormFactor) {
  auto scene = floor_scene();
  scene.lights.push_back(
      {"l", scene::SphereShape{0.25}, {2, 2, 2}, translation({0.2, 1, 0}) * scaling({2, 2, 2}), {}});
  const auto image = render_with_cycles(scene, "sphere", 2048);
  const auto expected = [&](int x, int y) {
    const Vec3d to_lamp = Vec3d{0.2, 1, 0} - floor_point(scene, x, y);
    const double d2 = dot(to_lamp, to_lamp);
    return kFloorAlbedo * 2 * 0.25 / d2 / std::sqrt(d2);
  };
  expect_in_quarters(image, expected, 1e-3);
}

TEST(Cycles, MirrorReflectsByItsReflectanceAlone) {
  const auto image = render_with_cycles(lamp_in_mirror({0.75, 0.5, 1}), "mirror", 16);
  EXPECT_NEAR(value(image, 7, 4, 0), 1.5, 1e-6);
  EXPECT_NEAR(value(image, 7, 4, 1), 1, 1e-6);
  EXPECT_NEAR(value(image, 7, 4, 2), 2, 1e-6);
  EXPECT_EQ(value(image, 1, 4, 0), 0);
}

TEST(Cycles, GlassIsInvisibleInAUniformEnvironment) {
  const auto image = render_with_cycles(glass_ball_in_uniform_light(64), "furnace", 256);
  expect_in_quarters(
      image, [](int, int) { return 1.0; }, 1e-3);
}

TEST(Cycles, GlassSlabTransmitsWithAllItsInterreflections) {
  const auto image = render_with_cycles(glass_slab(32, 32), "slab", 256);
  expect_in_quarters(
      image, [](int, int) { return kSlabTransmission; }, 1e-4);
}

// The mean over a pixel of the definition. The values of a pixel spread over at most 0.05, evenly at worst,
// which 256 samples average to 0.05 / sqrt(12 * 256) = 9e-4 or better; four of these.
TEST(Cycles, TexturesLieWhereTheyShould) {
  Mat4 matrix{};
  matrix.m = {0.8, -0.3, 0, 0.5, 0.2, 0.6, 0, -0.7, 0, 0, 1, 0, 0, 0, 0, 1};
  const Look look{.name = "texture", .wrap_v = scene::Wrap::Clamp, .matrix = matrix};
  const auto scene = texture_scene(look, std::filesystem::path(ORBS_BINARY_DIR) / "cycles tests");
  const auto image = render_with_cycles(scene, look.name, 256);
  constexpr int kGrid = 8;
  for (int y = 0; y < kTexturePixels; ++y)
    for (int x = 0; x < kTexturePixels; ++x) {
      double expected = 0;
      for (int i = 0; i < kGrid * kGrid; ++i)
        expected += texture_value(look, x + (i % kGrid + 0.5) / kGrid, y + (i / kGrid + 0.5) / kGrid);
      expected /= kGrid * kGrid;
      ASSERT_NEAR(value(image, x, y), expected, 3.6e-3) << x << " " << y;
    }
}

// Of direct light the wall shows 0.5 * 0.5; each further scattering adds a quarter of the one before.
TEST(Cycles, TraceDepthCountsScatterings) {
  auto scene = integrating_sphere(32, 128);
  for (const auto& [depth, radiance] : {std::pair{1, 0.25}, {2, 0.3125}, {3, 0.328125}}) {
    scene.trace_depth = depth;
    const auto image = render_with_cycles(scene, "depth" + std::to_string(depth), 256);
    expect_in_quarters(
        image, [radiance = radiance](int, int) { return radiance; }, 1e-3);
  }
}

}  // namespace
