#include "peers/povray_scenes.h"

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

/// Direct light of POV-Ray's light sources against exact form factors F: a Lambert surface shows L = rho L_e
/// F.
namespace {

using namespace orbs;
using namespace orbs::peers;
using std::numbers::pi;

constexpr double kAlbedo = 0.5;
constexpr int kSize = 24;

// Camera 1 m above a floor at y = 0, looking down; the light is up to the caller.
scene::Scene floor_scene() {
  auto scene = empty_scene(kSize, kSize, 90);
  scene.camera.position_m = {0, 0.5, 0};
  scene.camera.look_at_m = {0, 0, 0};
  scene.camera.up = {0, 0, -1};
  add_instance(scene, quad({-9, 0, 9}, {18, 0, 0}, {0, 0, -18}),
               add_material(scene, scene::Lambert{{kAlbedo, kAlbedo, kAlbedo}, {}}));
  return scene;
}

Vec3d floor_point(const scene::Scene& scene, int x, int y) {
  const Vec3d direction = pixel_direction(scene.camera, x, y);
  return scene.camera.position_m + direction * (scene.camera.position_m.y / -direction.y);
}

// Lambert's polygon formula for a receiver with normal +Y: F = 1/(2 pi) |sum of angle(v_i, v_i+1) n .
// unit(v_i x v_i+1)|.
double polygon_factor(Vec3d receiver, const std::array<Vec3d, 4>& corners) {
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3d a = normalised(corners[i] - receiver);
    const Vec3d b = normalised(corners[(i + 1) % 4] - receiver);
    const Vec3d across = cross(a, b);
    sum += std::atan2(length(across), dot(a, b)) * across.y / length(across);
  }
  return std::abs(sum) / (2 * pi);
}

template <typename Factor>
double worst_relative_error(const scene::Scene& scene, const std::string& name, const Factor& factor) {
  const auto image = render_with_povray(scene, name);
  double worst = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const double expected = kAlbedo * scene.lights[0].radiance.x * factor(floor_point(scene, x, y));
      worst = std::max(worst, std::abs(static_cast<double>(image.at(x, y, 0)) / expected - 1));
    }
  return worst;
}

TEST(PovrayLight, RectGivesItsFormFactor) {
  auto scene = floor_scene();
  scene.lights.push_back({"l", scene::RectShape{0.5, 0.5}, {pi, pi, pi}, translation({0, 1, 0}), {}});
  const std::array<Vec3d, 4> corners{{{-0.5, 1, -0.5}, {0.5, 1, -0.5}, {0.5, 1, 0.5}, {-0.5, 1, 0.5}}};
  EXPECT_LT(worst_relative_error(scene, "rect", [&](Vec3d p) { return polygon_factor(p, corners); }), 2e-3);
}

TEST(PovrayLight, TurnedAndStretchedRectGivesItsFormFactor) {
  auto scene = floor_scene();
  const Mat4 matrix = translation({0.3, 1.5, -0.2}) * rotation_x(30) * rotation_y(20) * rotation_z(-15) *
                      scaling({2, 1, 0.5});
  scene.lights.push_back({"l", scene::RectShape{0.25, 0.5}, {pi, pi, pi}, matrix, {}});
  std::array<Vec3d, 4> corners{{{-0.25, 0, -0.5}, {0.25, 0, -0.5}, {0.25, 0, 0.5}, {-0.25, 0, 0.5}}};
  for (auto& corner : corners) corner = transform_point(matrix, corner);
  EXPECT_LT(worst_relative_error(scene, "rect-turned", [&](Vec3d p) { return polygon_factor(p, corners); }),
            1e-3);
}

// F = 1/2 [1 - (a^2 + h^2 - r^2) / sqrt((a^2 + h^2 + r^2)^2 - 4 a^2 r^2)], parallel disc of radius r, height
// h, offset a.
TEST(PovrayLight, DiskGivesItsFormFactor) {
  auto scene = floor_scene();
  scene.lights.push_back({"l", scene::DiskShape{0.5}, {2, 2, 2}, translation({0, 1, 0}), {}});
  const auto factor = [](Vec3d p) {
    const double a2 = p.x * p.x + p.z * p.z;
    const double sum = a2 + 1 + 0.25;
    return 0.5 * (1 - (a2 + 1 - 0.25) / std::sqrt(sum * sum - a2));
  };
  EXPECT_LT(worst_relative_error(scene, "disk", factor), 3e-3);
}

// Wholly above the horizon: F = (r / d)^2 cos.
TEST(PovrayLight, SphereGivesItsFormFactor) {
  auto scene = floor_scene();
  scene.lights.push_back(
      {"l", scene::SphereShape{0.25}, {2, 2, 2}, translation({0, 1, 0}) * scaling({2, 2, 2}), {}});
  const auto factor = [](Vec3d p) {
    const double d2 = p.x * p.x + p.z * p.z + 1;
    return 0.25 / d2 / std::sqrt(d2);
  };
  EXPECT_LT(worst_relative_error(scene, "sphere", factor), 1e-3);
}

// One lamp beside the camera and two further ones that must not reach the floor: behind a lamp's black back,
// and a lamp that faces away. Their fronts and backs are what the camera sees of them.
TEST(PovrayLight, LampsShineForwardsAndAreBlackBehind) {
  auto scene = empty_scene(kSize, kSize, 60);
  scene.lights.push_back(
      {"to us", scene::DiskShape{1}, {5, 5, 5}, translation({-1.5, 0, -4}) * rotation_x(-90), {}});
  scene.lights.push_back(
      {"from us", scene::RectShape{1, 1}, {7, 7, 7}, translation({1.5, 0, -4}) * rotation_x(90), {}});
  add_instance(scene, quad({-9, -9, -6}, {18, 0, 0}, {0, 18, 0}),
               add_material(scene, scene::Lambert{{1, 1, 1}, {}}));
  const auto image = render_with_povray(scene, "one-sided");
  EXPECT_EQ(image.at(4, 12, 0), 5);      // the disc faces the camera
  EXPECT_EQ(image.at(19, 12, 0), 0);     // the rect shows its back
  EXPECT_GT(image.at(12, 12, 0), 0.1F);  // and lights the wall behind it
}

TEST(PovrayLight, SphereLampsStandInEachOthersLight) {
  auto scene = floor_scene();
  scene.lights.push_back({"high", scene::SphereShape{0.01}, {1000, 1000, 1000}, translation({0, 3, 0}), {}});
  scene.lights.push_back({"low", scene::SphereShape{0.1}, {0, 0, 0}, translation({0.15, 2, 0}), {}});
  const auto image = render_with_povray(scene, "lamp-shadow");
  // The low lamp's shadow on the floor reaches from x = 3 (0.15 -+ 0.1) / 1 = 0.15 ... 0.75 m.
  for (int x = 0; x < kSize; ++x) {
    const Vec3d point = floor_point(scene, x, 12);
    const bool dark = point.x > 0.2 && point.x < 0.45;
    if (dark) {
      EXPECT_EQ(image.at(x, 12, 0), 0) << point.x;
    } else if (point.x < 0.1) {
      EXPECT_GT(image.at(x, 12, 0), 0) << point.x;
    }
  }
}

}  // namespace
