#include "peers/povray_render.h"
#include "peers/scenes.h"

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

constexpr int kSize = 24;

// Worst relative difference of two form factors over the pixels of the floor.
template <typename Factor, typename Other>
double worst_difference(const scene::Scene& scene, const Factor& factor, const Other& other) {
  double worst = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const Vec3d point = floor_point(scene, x, y);
      worst = std::max(worst, std::abs(factor(point, x, y) / other(point, x, y) - 1));
    }
  return worst;
}

// What the image shows of its only light, as a form factor.
auto shown_in(const image::Image& image, const scene::Scene& scene) {
  return [&image, &scene](Vec3d, int x, int y) {
    return static_cast<double>(image.at(x, y, 0)) / (kFloorAlbedo * scene.lights[0].radiance.x);
  };
}

// POV-Ray's lamp is a grid of points of equal weight, and so a quadrature of the form factor: the mean over
// the points of area cos cos / (pi d^2). Points are given in the lamp's local XZ plane.
class LampGrid {
 public:
  LampGrid(const Mat4& matrix, double local_area_m2, const std::vector<std::array<double, 2>>& local_points) {
    const Vec3d across =
        cross(transform_direction(matrix, {1, 0, 0}), transform_direction(matrix, {0, 0, 1}));
    normal_ = normalised(across);
    area_m2_ = local_area_m2 * length(across);
    for (const auto& [x, z] : local_points) points_.push_back(transform_point(matrix, {x, 0, z}));
  }

  double operator()(Vec3d receiver, int, int) const {
    double sum = 0;
    for (const Vec3d point : points_) {
      const Vec3d d = point - receiver;
      const double d2 = dot(d, d);
      sum += d.y * std::abs(dot(d, normal_)) / (pi * d2 * d2);
    }
    return sum * area_m2_ / static_cast<double>(points_.size());
  }

 private:
  Vec3d normal_;
  double area_m2_ = 0;
  std::vector<Vec3d> points_;
};

// The centres of n x n cells.
LampGrid rect_grid(const Mat4& matrix, scene::RectShape rect, int n) {
  std::vector<std::array<double, 2>> points;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      points.push_back(
          {((2 * i + 1.0) / n - 1) * rect.half_width_m, ((2 * j + 1.0) / n - 1) * rect.half_length_m});
  return {matrix, 4 * rect.half_width_m * rect.half_length_m, points};
}

// The same cells of the square around the disc, each drawn towards the centre until squares have become
// circles; and all of it once more, turned by 45 degrees. POV-Ray displaces the cells by 0.001 of the grid,
// and the exporter moves the lamp by 0.88 of that against it.
LampGrid disk_grid(const Mat4& matrix, double radius_m, int n) {
  std::vector<std::array<double, 2>> points;
  const double displaced = 0.002 * radius_m * (n - 1) / n;
  const double turn = std::numbers::sqrt2 / 2;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double x = ((2 * i + 1.0) / n - 1) * radius_m + displaced;
      const double z = ((2 * j + 1.0) / n - 1) * radius_m + displaced;
      const double inwards = std::max(std::abs(x), std::abs(z)) / std::hypot(x, z);
      const double u = x * inwards - 0.8814 * displaced;
      const double v = z * inwards - 0.8814 * displaced;
      points.push_back({u, v});
      points.push_back({(u - v) * turn, (u + v) * turn});
    }
  return {matrix, pi * radius_m * radius_m, points};
}

const int kGrid = adapters::PovraySettings{}.area_grid;

// Two questions, so that each tolerance has a reason: the image is that of the grid but for its half
// floats, and the grid is off by its quadrature alone. Over a cell of side h the mean of f and its value in
// the middle differ by h^2 / 24 of its second derivatives: 7.4e-4 of the form factor at most on this floor
// for 16 x 16 cells, and four times that for 8 x 8.
TEST(PovrayLight, RectGivesItsFormFactor) {
  auto scene = floor_scene();
  const scene::RectShape rect{0.5, 0.5};
  scene.lights.push_back({"l", rect, {pi, pi, pi}, translation({0, 1, 0}), {}});
  const auto image = render_with_povray(scene, "rect");
  const auto grid = rect_grid(scene.lights[0].matrix, rect, kGrid);
  EXPECT_LT(worst_difference(scene, shown_in(image, scene), grid), kHalf);
  const std::array<Vec3d, 4> corners{{{-0.5, 1, -0.5}, {0.5, 1, -0.5}, {0.5, 1, 0.5}, {-0.5, 1, 0.5}}};
  const auto exact = [&](Vec3d p, int, int) { return polygon_factor(p, corners); };
  EXPECT_LT(worst_difference(scene, grid, exact), 7.5e-4);
}

// 1 m x 0.5 m at 1.5 m above the floor: cells seen under smaller angles than those above.
TEST(PovrayLight, TurnedAndStretchedRectGivesItsFormFactor) {
  auto scene = floor_scene();
  const Mat4 matrix = translation({0.3, 1.5, -0.2}) * rotation_x(30) * rotation_y(20) * rotation_z(-15) *
                      scaling({2, 1, 0.5});
  const scene::RectShape rect{0.25, 0.5};
  scene.lights.push_back({"l", rect, {pi, pi, pi}, matrix, {}});
  const auto image = render_with_povray(scene, "rect-turned");
  const auto grid = rect_grid(matrix, rect, kGrid);
  EXPECT_LT(worst_difference(scene, shown_in(image, scene), grid), kHalf);
  std::array<Vec3d, 4> corners{{{-0.25, 0, -0.5}, {0.25, 0, -0.5}, {0.25, 0, 0.5}, {-0.25, 0, 0.5}}};
  for (auto& corner : corners) corner = transform_point(matrix, corner);
  const auto exact = [&](Vec3d p, int, int) { return polygon_factor(p, corners); };
  EXPECT_LT(worst_difference(scene, grid, exact), 3e-4);
}

// F = 1/2 [1 - (a^2 + h^2 - r^2) / sqrt((a^2 + h^2 + r^2)^2 - 4 a^2 r^2)], parallel disc of radius r, height
// h, offset a. Rings at (2k + 1) / n of the radius R, with weights in proportion, have the mean square radius
// R^2 / 2 (1 - 2 / n^2), where cells of a square lose 1 / n^2 of their second moment: twice the error of the
// square.
TEST(PovrayLight, DiskGivesItsFormFactor) {
  auto scene = floor_scene();
  scene.lights.push_back({"l", scene::DiskShape{0.5}, {2, 2, 2}, translation({0, 1, 0}), {}});
  const auto image = render_with_povray(scene, "disk");
  const auto grid = disk_grid(scene.lights[0].matrix, 0.5, kGrid);
  EXPECT_LT(worst_difference(scene, shown_in(image, scene), grid), kHalf);
  const auto exact = [](Vec3d p, int, int) {
    const double a2 = p.x * p.x + p.z * p.z;
    const double sum = a2 + 1 + 0.25;
    return 0.5 * (1 - (a2 + 1 - 0.25) / std::sqrt(sum * sum - a2));
  };
  EXPECT_LT(worst_difference(scene, grid, exact), 1.5e-3);
}

// Wholly above the horizon: F = (r / d)^2 cos.
TEST(PovrayLight, SphereGivesItsFormFactor) {
  auto scene = floor_scene();
  scene.lights.push_back(
      {"l", scene::SphereShape{0.25}, {2, 2, 2}, translation({0, 1, 0}) * scaling({2, 2, 2}), {}});
  const auto exact = [](Vec3d p, int, int) {
    const double d2 = p.x * p.x + p.z * p.z + 1;
    return 0.25 / d2 / std::sqrt(d2);
  };
  const auto image = render_with_povray(scene, "sphere");
  EXPECT_LT(worst_difference(scene, shown_in(image, scene), exact), kHalf);
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
