// The harness' own answer to what a camera sees, against projections worked out by hand.
#include "studies/probe/primary_visibility.h"

#include "scene/geometry/generators.h"
#include "scene/scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

using namespace orbs;
using studies::kNoObject;
using studies::VisibleSurface;

namespace {

// At the origin, looking along -Z with a field of 90 degrees: at distance d the image is 2 d high.
scene::Scene empty_view(int size_px) {
  scene::Scene scene;
  scene.camera.look_at_m = {0, 0, -1};
  scene.camera.fov_y_deg = 90;
  scene.camera.width_px = scene.camera.height_px = size_px;
  return scene;
}

void add_triangle(scene::Scene& scene, std::array<Vec3f, 3> corners, std::array<Vec2f, 3> uvs = {}) {
  scene::Mesh mesh;
  mesh.positions.assign(corners.begin(), corners.end());
  mesh.normals.assign(3, {0, 0, 1});
  mesh.tangents.assign(3, {});
  mesh.uvs.assign(uvs.begin(), uvs.end());
  mesh.triangles = {{0, 1, 2}};
  mesh.triangle_materials = {static_cast<int>(scene.materials.size())};
  scene.materials.push_back({"", scene::Lambert{}});
  scene.instances.push_back({"", static_cast<int>(scene.meshes.size()), {}, {}});
  scene.meshes.push_back(mesh);
}

std::set<int> things_in(const scene::Scene& scene, int x, int y, studies::VisibilityGrid grid = {}) {
  std::set<int> objects;
  for (const auto& surface : studies::visible_surfaces_of_pixels(scene, {{x, y}}, grid, 1))
    objects.insert(surface.object);
  return objects;
}

double share_of(const std::vector<VisibleSurface>& surfaces, int object) {
  const auto count = std::count_if(surfaces.begin(), surfaces.end(),
                                   [&](const VisibleSurface& s) { return s.object == object; });
  return static_cast<double>(count) / static_cast<double>(surfaces.size());
}

}  // namespace

TEST(PrimaryVisibility, ATriangleCoversThePixelsThatItIsProjectedOn) {
  auto scene = empty_view(16);
  // At distance 8 a pixel is 1 m wide: this one reaches from pixel 4 to pixel 12 along the image's middle.
  add_triangle(scene, {Vec3f{-4, 0, -8}, Vec3f{4, 0, -8}, Vec3f{-4, 8, -8}});
  EXPECT_EQ(things_in(scene, 5, 6), std::set<int>{0});
  EXPECT_EQ(things_in(scene, 3, 4), (std::set<int>{kNoObject, 0}));  // by the margin of the grid
  EXPECT_EQ(things_in(scene, 2, 4), std::set<int>{kNoObject});
  EXPECT_EQ(things_in(scene, 8, 8), (std::set<int>{kNoObject, 0}));
  EXPECT_EQ(things_in(scene, 8, 9), std::set<int>{kNoObject});
  EXPECT_EQ(things_in(scene, 11, 7), (std::set<int>{kNoObject, 0}));  // the diagonal
}

// The window has moved by four of 16 pixels to the right and by two down.
TEST(PrimaryVisibility, AShiftedWindowMovesTheTriangleTheOtherWay) {
  auto scene = empty_view(16);
  scene.camera.shift = {0.25, -0.125};
  add_triangle(scene, {Vec3f{-4, 0, -8}, Vec3f{4, 0, -8}, Vec3f{-4, 8, -8}});
  EXPECT_EQ(things_in(scene, 1, 4), std::set<int>{0});
  EXPECT_EQ(things_in(scene, 7, 5), (std::set<int>{kNoObject, 0}));
  EXPECT_EQ(things_in(scene, 5, 6), (std::set<int>{kNoObject, 0}));
  EXPECT_EQ(things_in(scene, 5, 7), std::set<int>{kNoObject});
}

TEST(PrimaryVisibility, TheNearerOneHidesTheOther) {
  auto scene = empty_view(8);
  add_triangle(scene, {Vec3f{-90, -90, -9}, Vec3f{90, -90, -9}, Vec3f{0, 90, -9}});
  add_triangle(scene, {Vec3f{-90, -90, -8}, Vec3f{90, -90, -8}, Vec3f{0, 90, -8}});
  EXPECT_EQ(things_in(scene, 4, 4), std::set<int>{1});
}

TEST(PrimaryVisibility, ATriangleThatBeginsBehindTheCameraIsSeenInFrontOfIt) {
  auto scene = empty_view(16);
  // A floor 1 m below, from far behind to far before the camera.
  add_triangle(scene, {Vec3f{-1000, -1, 1000}, Vec3f{1000, -1, 1000}, Vec3f{0, -1, -1000}});
  EXPECT_EQ(things_in(scene, 8, 12), std::set<int>{0});
  EXPECT_EQ(things_in(scene, 8, 4), std::set<int>{kNoObject});
}

TEST(PrimaryVisibility, WhatIsBehindTheCameraIsNotSeen) {
  auto scene = empty_view(8);
  add_triangle(scene, {Vec3f{-90, -90, 2}, Vec3f{90, -90, 2}, Vec3f{0, 90, 2}});
  EXPECT_EQ(share_of(studies::primary_visibility(scene, {}, 1), kNoObject), 1);
}

TEST(PrimaryVisibility, CoordinatesAreInterpolatedInPerspective) {
  auto scene = empty_view(2);
  // Its plane runs away from the camera: z = -1 where x = -1, z = -3 where x = 3. The ray through the middle
  // of the image meets it halfway between x = -1 and x = 1, at u = 1/4 of the way, not at half the image.
  add_triangle(scene, {Vec3f{-1, -9, -1}, Vec3f{3, -9, -3}, Vec3f{-1, 27, -1}},
               {Vec2f{0, 0}, Vec2f{1, 0}, Vec2f{0, 1}});
  const auto surfaces = studies::visible_surfaces_of_pixels(scene, {{0, 0}}, {3, 0}, 1);
  EXPECT_NEAR(surfaces[8].u, 0.25, 1e-6);  // the lower right corner of the upper left pixel
  EXPECT_NEAR(surfaces[8].v, 0.25, 1e-6);  // y = 0: a quarter from -9 to 27
}

TEST(PrimaryVisibility, AFlatLightIsSeenFromItsFrontAndIsBlackBehind) {
  for (const double turn_deg : {90.0, -90.0}) {
    auto scene = empty_view(8);
    add_triangle(scene, {Vec3f{-90, -90, -9}, Vec3f{90, -90, -9}, Vec3f{0, 90, -9}});
    scene.lights.push_back(
        {"", scene::RectShape{1, 1}, {1, 1, 1}, translation({0, 0, -2}) * rotation_x(turn_deg), {}});
    // Local -Y turned by -90 degrees about X points to +Z, at the camera.
    EXPECT_EQ(things_in(scene, 4, 4), std::set<int>{turn_deg < 0 ? 1 : kNoObject});
    EXPECT_EQ(things_in(scene, 0, 4), std::set<int>{0});
  }
}

TEST(PrimaryVisibility, ASphereOnTheAxisCoversItsConesDisc) {
  auto scene = empty_view(64);
  scene.lights.push_back(
      {"", scene::SphereShape{0.5}, {1, 1, 1}, translation({0, 0, -2}) * scaling({2, 2, 2}), {}});
  // Radius 1 at distance 2: the cone's tangent is 1 / sqrt(3), of an image whose half side is 1.
  const double expected = std::numbers::pi / 3 / 4;
  EXPECT_NEAR(share_of(studies::primary_visibility(scene, {8, -1.0 / 16}, 1), 0), expected, 2e-3);
}

// It gives light outwards alone.
TEST(PrimaryVisibility, ASphereIsBlackFromWithin) {
  auto scene = empty_view(4);
  scene.lights.push_back({"", scene::SphereShape{1}, {1, 1, 1}, translation({0, 0, 0.5}), {}});
  EXPECT_EQ(share_of(studies::primary_visibility(scene, {}, 1), kNoObject), 1);
}

TEST(PrimaryVisibility, AnEllipseOfADiskStaysOne) {
  auto scene = empty_view(64);
  scene.lights.push_back({"",
                          scene::DiskShape{1},
                          {1, 1, 1},
                          translation({0, 0, -4}) * rotation_x(-90) * scaling({2, 1, 1}),
                          {}});
  EXPECT_NEAR(share_of(studies::primary_visibility(scene, {8, -1.0 / 16}, 1), 0), std::numbers::pi * 2 / 64,
              1e-3);
}
