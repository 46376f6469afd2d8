#include "scene/geometry/generators.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include <gtest/gtest.h>

namespace orbs::scene {
namespace {

struct Bounds {
  Vec3f low;
  Vec3f high;
};

Bounds bounds_of(const Mesh& mesh) {
  Bounds b{mesh.positions.front(), mesh.positions.front()};
  for (const Vec3f p : mesh.positions) {
    b.low = {std::min(b.low.x, p.x), std::min(b.low.y, p.y), std::min(b.low.z, p.z)};
    b.high = {std::max(b.high.x, p.x), std::max(b.high.y, p.y), std::max(b.high.z, p.z)};
  }
  return b;
}

Vec3d corner(const Mesh& mesh, std::size_t triangle, std::size_t i) {
  return cast<double>(mesh.positions[mesh.triangles[triangle][i]]);
}

/// Twice the area, in the direction that the winding says is outside.
Vec3d wound_normal(const Mesh& mesh, std::size_t triangle) {
  const Vec3d a = corner(mesh, triangle, 0);
  return cross(corner(mesh, triangle, 1) - a, corner(mesh, triangle, 2) - a);
}

Vec3d mean_vertex_normal(const Mesh& mesh, std::size_t triangle) {
  Vec3d sum;
  for (const auto i : mesh.triangles[triangle]) sum += cast<double>(mesh.normals[i]);
  return sum / 3.0;
}

/// Triangles whose winding agrees with their vertex normals, disagrees, and those without area (two corners
/// coincide).
struct Winding {
  int with = 0;
  int against = 0;
  int without_area = 0;
  friend bool operator==(const Winding&, const Winding&) = default;
};

Winding winding_of(const Mesh& mesh) {
  Winding w;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3d a = corner(mesh, t, 0);
    const Vec3d b = corner(mesh, t, 1);
    const Vec3d c = corner(mesh, t, 2);
    const double shortest = std::min({length(b - a), length(c - b), length(a - c)});
    const double side = dot(wound_normal(mesh, t), mean_vertex_normal(mesh, t));
    if (shortest < 1e-6)
      ++w.without_area;
    else
      ++(side > 0 ? w.with : w.against);
  }
  return w;
}

void expect_sound(const Mesh& mesh, std::size_t triangles) {
  EXPECT_EQ(mesh.triangles.size(), triangles);
  EXPECT_TRUE(mesh.name.empty());
  EXPECT_TRUE(mesh.triangle_materials.empty());
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  ASSERT_EQ(mesh.tangents.size(), mesh.positions.size());
  ASSERT_EQ(mesh.uvs.size(), mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    EXPECT_TRUE(is_finite(mesh.positions[i])) << i;
    EXPECT_NEAR(length(cast<double>(mesh.normals[i])), 1, 1e-6) << i;
    EXPECT_EQ(mesh.tangents[i], Vec3f{}) << i;
    EXPECT_TRUE(std::isfinite(mesh.uvs[i].x) && std::isfinite(mesh.uvs[i].y)) << i;
  }
  for (const auto& t : mesh.triangles)
    for (const auto i : t) ASSERT_LT(i, mesh.positions.size());
}

void expect_uv(const Mesh& mesh, Vec3f normal, Vec2d (*expected)(Vec3f)) {
  int found = 0;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (mesh.normals[i] != normal) continue;
    ++found;
    const Vec2d uv = expected(mesh.positions[i]);
    EXPECT_FLOAT_EQ(mesh.uvs[i].x, static_cast<float>(uv.x)) << i;
    EXPECT_FLOAT_EQ(mesh.uvs[i].y, static_cast<float>(uv.y)) << i;
  }
  EXPECT_EQ(found, 4);
}

/// Edges by position that are not shared by exactly two triangles which run along them in opposite
/// directions.
int open_edges(const Mesh& mesh) {
  using Point = std::tuple<float, float, float>;
  std::map<std::pair<Point, Point>, int> balance;
  const auto point = [&](std::uint32_t i) {
    const Vec3f p = mesh.positions[i];
    return Point{p.x, p.y, p.z};
  };
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Point a = point(t[k]);
      const Point b = point(t[(k + 1) % 3]);
      if (a < b) ++balance[{a, b}];
      if (b < a) --balance[{b, a}];
    }
  return static_cast<int>(
      std::count_if(balance.begin(), balance.end(), [](const auto& e) { return e.second != 0; }));
}

/// Volume enclosed by a closed mesh that is wound counter-clockwise seen from outside (divergence theorem).
double volume_of(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    sum += dot(corner(mesh, t, 0), cross(corner(mesh, t, 1), corner(mesh, t, 2))) / 6;
  return sum;
}

// The scene's budget is held against the count before anything is made.
TEST(Generators, TheCountIsKnownBefore) {
  const auto expect_counted = [](const auto& parameters, auto make) {
    EXPECT_EQ(triangle_count(parameters), make(parameters).triangles.size());
  };
  expect_counted(PlaneParameters{}, make_plane);
  expect_counted(CubeParameters{}, make_cube);
  expect_counted(SphereParameters{1, 6}, make_sphere);
  expect_counted(TorusParameters{0.2, 1, 5, 7}, make_torus);
  expect_counted(TeapotParameters{3}, make_teapot);
  expect_counted(TreeParameters{4, 1, 3, 5}, make_tree);
  expect_counted(WaterParameters{1, 1, 1, 0.1, 1, 7}, make_water);
  EXPECT_GE(triangle_count(CubeParameters{}), make_cube_open({}).triangles.size());
}

TEST(Generators, PlaneLiesAtZeroAndSharesTheDiagonalFromMinusToPlus) {
  const Mesh plane = make_plane({3});
  expect_sound(plane, 2);
  expect_uv(plane, {0, 1, 0}, [](Vec3f p) { return Vec2d{(p.x + 3.0) / 6, (p.z + 3.0) / 6}; });
  for (std::size_t t = 0; t < 2; ++t) {
    std::vector<Vec3d> corners;
    for (std::size_t i = 0; i < 3; ++i) corners.push_back(corner(plane, t, i));
    EXPECT_EQ(std::count(corners.begin(), corners.end(), Vec3d{-3, 0, -3}), 1);
    EXPECT_EQ(std::count(corners.begin(), corners.end(), Vec3d{3, 0, 3}), 1);
  }
  EXPECT_EQ(winding_of(plane),
            (Winding{0, 2, 0}));  // against the vertex normals: these decide, not the winding
}

TEST(Generators, CubeHasSideTwoAAndFacesInTheOrderMinusPlusYZX) {
  const Mesh cube = make_cube({2});
  expect_sound(cube, 12);
  EXPECT_EQ(cube.positions.size(), 24U);
  EXPECT_EQ(bounds_of(cube).low, (Vec3f{-2, -2, -2}));
  EXPECT_EQ(bounds_of(cube).high, (Vec3f{2, 2, 2}));
  const std::array<Vec3d, 6> order{Vec3d{0, -1, 0}, Vec3d{0, 1, 0},  Vec3d{0, 0, -1},
                                   Vec3d{0, 0, 1},  Vec3d{-1, 0, 0}, Vec3d{1, 0, 0}};
  for (std::size_t t = 0; t < 12; ++t) EXPECT_EQ(mean_vertex_normal(cube, t), order[t / 2]) << t;
  EXPECT_EQ(winding_of(cube), (Winding{12, 0, 0}));
  EXPECT_DOUBLE_EQ(volume_of(cube), 64);
  EXPECT_EQ(open_edges(cube), 0);
}

TEST(Generators, CubeTextureCoordinatesFollowTheTableOfFaces) {
  const Mesh cube = make_cube({1});
  expect_uv(cube, {0, -1, 0}, [](Vec3f p) { return Vec2d{(p.x + 1.0) / 2, (p.z + 1.0) / 2}; });
  expect_uv(cube, {0, 1, 0}, [](Vec3f p) { return Vec2d{(1.0 - p.x) / 2, (p.z + 1.0) / 2}; });
  const auto by_xy = [](Vec3f p) { return Vec2d{(p.x + 1.0) / 2, (p.y + 1.0) / 2}; };
  expect_uv(cube, {0, 0, -1}, by_xy);
  expect_uv(cube, {0, 0, 1}, by_xy);
  const auto by_yz = [](Vec3f p) { return Vec2d{(p.y + 1.0) / 2, (p.z + 1.0) / 2}; };
  expect_uv(cube, {-1, 0, 0}, by_yz);
  expect_uv(cube, {1, 0, 0}, by_yz);
}

TEST(Generators, OpenCubeLacksMinusZAndLooksInwards) {
  const Mesh room = make_cube_open({4});
  expect_sound(room, 10);
  const std::array<Vec3d, 5> order{Vec3d{0, 1, 0}, Vec3d{0, -1, 0}, Vec3d{0, 0, -1}, Vec3d{1, 0, 0},
                                   Vec3d{-1, 0, 0}};
  for (std::size_t t = 0; t < 10; ++t) {
    EXPECT_EQ(mean_vertex_normal(room, t), order[t / 2]) << t;
    EXPECT_DOUBLE_EQ(dot(corner(room, t, 0), order[t / 2]), -4)
        << t;  // the wall stands where its normal comes from
  }
  EXPECT_EQ(winding_of(room), (Winding{0, 10, 0}));
}

// The room of the two-light scene shows a glossy second ceiling triangle: (4,4,4), (-4,4,-4), (-4,4,4) once
// turned by RY(180).
TEST(Generators, SecondCeilingTriangleOfTheTurnedRoomIsTheOneAtMinusXPlusZ) {
  const Mesh room = make_cube_open({4});
  std::vector<Vec3d> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3d p = corner(room, 3, i);
    corners.push_back({-p.x, p.y, -p.z});
  }
  for (const Vec3d expected : {Vec3d{4, 4, 4}, Vec3d{-4, 4, -4}, Vec3d{-4, 4, 4}})
    EXPECT_EQ(std::count(corners.begin(), corners.end(), expected), 1);
}

TEST(Generators, SphereHasNSquaredTrianglesOfWhichNHaveNoArea) {
  const Mesh sphere = make_sphere({2.5, 32});
  expect_sound(sphere, 32 * 32);
  EXPECT_EQ(winding_of(sphere), (Winding{32 * 32 - 2 * 32, 0, 2 * 32}));
  for (std::size_t i = 0; i < sphere.positions.size(); ++i)
    EXPECT_LT(length(cast<double>(sphere.positions[i]) - 2.5 * cast<double>(sphere.normals[i])), 1e-6) << i;
  EXPECT_EQ(sphere.positions[0], (Vec3f{0, 2.5F, 0}));
  for (std::size_t t = 0; t < 512; ++t) EXPECT_GT(mean_vertex_normal(sphere, t).y, 0) << t;
  for (std::size_t t = 512; t < 1024; ++t) EXPECT_LT(mean_vertex_normal(sphere, t).y, 0) << t;
}

TEST(Generators, SphereTextureUsesHalfTheHeightAndStartsAboveZero) {
  constexpr int n = 64;
  const Mesh sphere = make_sphere({1, n});
  ASSERT_EQ(sphere.positions.size(), std::size_t{n / 2 + 1} * (n + 1));
  for (int i = 0; i <= n / 2; ++i)
    for (int j = 0; j <= n; ++j) {
      const auto at = static_cast<std::size_t>(i * (n + 1) + j);
      EXPECT_FLOAT_EQ(sphere.uvs[at].x, static_cast<float>(j / 64.0));
      EXPECT_FLOAT_EQ(sphere.uvs[at].y, static_cast<float>((1.0 - i) / 63));
    }
  const std::size_t quarter = std::size_t{n / 4} * (n + 1) + n / 4;  // equator, a quarter turn from +Z
  EXPECT_NEAR(sphere.positions[quarter].x, 1, 1e-6);
}

TEST(Generators, SphereRefusesAnOddNumberOfSegments) {
  try {
    make_sphere({1, 7});
    FAIL() << "accepted";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("even number of segments, not 7"), std::string::npos) << e.what();
  }
}

TEST(Generators, TorusLiesInTheXyPlaneAndRunsFromPlusXTowardsPlusY) {
  const Mesh torus = make_torus({0.8, 2, 64, 32});
  expect_sound(torus, 2 * 64 * 32);
  EXPECT_EQ(winding_of(torus), (Winding{2 * 64 * 32, 0, 0}));
  EXPECT_EQ(open_edges(torus), 0);
  EXPECT_NEAR(bounds_of(torus).high.x, 2.8, 1e-6);
  EXPECT_NEAR(bounds_of(torus).high.y, 2.8, 1e-6);
  EXPECT_NEAR(bounds_of(torus).high.z, 0.8, 1e-6);
  for (std::size_t t = 0; t < torus.triangles.size(); ++t) {
    const Vec3d middle = (corner(torus, t, 0) + corner(torus, t, 1) + corner(torus, t, 2)) / 3.0;
    const double turn = std::atan2(middle.y, middle.x) / (2 * std::numbers::pi);
    EXPECT_EQ(static_cast<std::size_t>(std::floor((turn < 0 ? turn + 1 : turn) * 64)), t / 64)
        << t;  // 64 triangles a step
  }
  EXPECT_EQ(torus.uvs[33], (Vec2f{0, 1.0F / 64}));  // first vertex of the second ring step
  EXPECT_EQ(torus.uvs[1], (Vec2f{1.0F / 32, 0}));
}

TEST(Generators, TeapotOfTwentySubdivisionsFillsItsBox) {
  const Mesh teapot = make_teapot({20});
  expect_sound(teapot, 25600);
  const auto [low, high] = bounds_of(teapot);
  const std::array<std::pair<float, double>, 6> sides{std::pair{low.x, -0.95239}, {high.x, 1.09017},
                                                      {low.y, -0.40505},          {high.y, 0.59507},
                                                      {low.z, -0.63493},          {high.z, 0.63493}};
  for (const auto& [found, wanted] : sides) {
    EXPECT_NEAR(found, wanted, 5e-4);
    EXPECT_LE(std::abs(found), std::abs(wanted));
  }
}

// Rows of the knob's top and of the bottom's centre are one point: n triangles on each of 8 patches have no
// area there.
TEST(Generators, TeapotIsWoundWithItsNormalsAndDegenerateAtTwoPolesOnly) {
  EXPECT_EQ(winding_of(make_teapot({20})), (Winding{25600 - 160, 0, 160}));
}

TEST(Generators, TeapotNormalsAtThePolesAreVertical) {
  const Mesh teapot = make_teapot({4});
  int poles = 0;
  for (std::size_t i = 0; i < teapot.positions.size(); ++i) {
    const Vec3f p = teapot.positions[i];
    if (p.x != 0 || p.z != 0) continue;
    ++poles;
    EXPECT_EQ(teapot.normals[i].y, p.y > 0 ? 1.0F : -1.0F);
    EXPECT_LT(std::hypot(teapot.normals[i].x, teapot.normals[i].z), 1e-12);
  }
  EXPECT_EQ(poles, 8 * 5);
}

TEST(Generators, TeapotPointsItsSpoutAlongPlusXAndItsNormalsOutwards) {
  const Mesh teapot = make_teapot({8});
  const auto by_x = [](Vec3f a, Vec3f b) { return a.x < b.x; };
  const Vec3f tip = *std::max_element(teapot.positions.begin(), teapot.positions.end(), by_x);
  EXPECT_GT(tip.y, 0.3F);  // nearly as high as the rim, where the handle would end lower
  // Widest ring of the body, 0.9 of Newell's units above the bottom: normals point away from the axis.
  int ring = 0;
  for (std::size_t i = 0; i < std::size_t{20} * 81; ++i) {
    const Vec3f p = teapot.positions[i];
    if (std::abs(std::hypot(p.x, p.z) - 2 / 3.15) > 2e-3) continue;
    ++ring;
    EXPECT_GT(p.x * teapot.normals[i].x + p.z * teapot.normals[i].z, 0.6F);
  }
  EXPECT_GT(ring, 30);
}

TEST(Generators, TreeIsATrunkOfSixteenTrianglesAndClosedTiers) {
  const TreeParameters parameters{5, 1.5, 4, 9};
  Mesh tree = make_tree(parameters);
  expect_sound(tree, kTreeTrunkTriangles + 4 * 4 * 9);
  EXPECT_EQ(winding_of(tree), (Winding{kTreeTrunkTriangles + 4 * 4 * 9, 0, 0}));
  EXPECT_FLOAT_EQ(bounds_of(tree).low.y, 0);
  EXPECT_FLOAT_EQ(bounds_of(tree).high.y, 5);
  for (const Vec3f p : tree.positions) EXPECT_LE(std::hypot(p.x, p.z), 1.5 + 1e-6);
  for (std::size_t t = 0; t < 16; ++t)
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_LT(std::hypot(corner(tree, t, i).x, corner(tree, t, i).z), 0.2) << "the trunk comes first";
  tree.triangles.erase(tree.triangles.begin(), tree.triangles.begin() + kTreeTrunkTriangles);
  EXPECT_EQ(open_edges(tree), 0);
  EXPECT_GT(volume_of(tree), 0);
}

TEST(Generators, TreesOfOneShapeAreEqual) { EXPECT_EQ(make_tree({}).positions, make_tree({}).positions); }

// The waves' mean over a large surface is nearly 0, so the volume is nearly that of the box.
TEST(Generators, WaterIsAClosedBoxWithAWavyTop) {
  const Mesh water = make_water({3, 2, 0.75, 0.1, 1.5, 48});
  expect_sound(water, 2 * 48 * 48 + 12 * 48);
  EXPECT_EQ(winding_of(water), (Winding{2 * 48 * 48 + 12 * 48, 0, 0}));
  EXPECT_EQ(open_edges(water), 0);
  EXPECT_NEAR(volume_of(water), 6 * 4 * 0.75, 0.5);
  const auto [low, high] = bounds_of(water);
  EXPECT_EQ(low, (Vec3f{-3, -0.75F, -2}));
  EXPECT_LE(high.y, 0.1F);
  EXPECT_GT(high.y, 0.05F);
}

TEST(Generators, WaterNormalsAreThoseOfItsSurface) {
  constexpr int n = 200;
  const Mesh water = make_water({1, 1, 1, 0.05, 1, n});
  for (int row = 1; row < n;
       ++row) {  // central differences along x; error of order (wave number * step)^2, about 1e-2
    const auto at = static_cast<std::size_t>(row * (n + 1) + row);
    const double rise = double(water.positions[at + 1].y) - double(water.positions[at - 1].y);
    const double slope = rise / (double(water.positions[at + 1].x) - double(water.positions[at - 1].x));
    EXPECT_NEAR(-water.normals[at].x / water.normals[at].y, slope, 2e-3) << row;
  }
}

}  // namespace
}  // namespace orbs::scene
