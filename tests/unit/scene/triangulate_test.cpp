// Polygons of faces: convex ones stay fans, concave ones are covered once.
#include "scene/geometry/triangulate.h"

#include "base/error.h"
#include "base/random.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using scene::triangulate;
using Outline = std::vector<Vec2d>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

constexpr double kPi = std::numbers::pi;

// Into the plane z = 0, and into one that no axis lies in, in floats as meshes have them.
std::vector<Vec3d> flat(const Outline& outline) {
  std::vector<Vec3d> corners;
  for (const Vec2d p : outline) corners.push_back({p.x, p.y, 0});
  return corners;
}

std::vector<Vec3d> tilted(const Outline& outline) {
  const Vec3d u = normalised(Vec3d{2, -1, 0.5});
  const Vec3d v = cross(normalised(Vec3d{1, 3, 2} - u * dot(u, Vec3d{1, 3, 2})), u);
  std::vector<Vec3d> corners;
  for (const Vec2d p : outline)
    corners.push_back(cast<double>(cast<float>(Vec3d{10, -7, 3} + u * p.x + v * p.y)));
  return corners;
}

Outline turned_by(Outline outline, std::size_t first) {
  std::rotate(outline.begin(), outline.begin() + static_cast<std::ptrdiff_t>(first), outline.end());
  return outline;
}

double turn(Vec2d a, Vec2d b, Vec2d c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

double area(const Outline& p) {
  double twice = 0;
  for (std::size_t i = 2; i < p.size(); ++i) twice += turn(p[0], p[i - 1], p[i]);
  return twice / 2;
}

// How often the outline runs around a point (Sunday 2001).
int winding(const Outline& outline, Vec2d p) {
  int turns = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2d a = outline[i];
    const Vec2d b = outline[(i + 1) % outline.size()];
    if (a.y <= p.y && b.y > p.y && turn(a, b, p) > 0) ++turns;
    if (a.y > p.y && b.y <= p.y && turn(a, b, p) < 0) --turns;
  }
  return turns;
}

// Each corner is used, no triangle is wound against the outline, and each of many points lies in as many
// triangles as the outline runs around it: one inside, none outside.
void expect_covered_once(const Outline& outline, const Triangles& triangles, const std::string& what) {
  ASSERT_EQ(triangles.size(), outline.size() - 2) << what;
  double sum = 0;
  std::vector<bool> is_used(outline.size());
  for (const auto& t : triangles) {
    const double own = area({outline[t[0]], outline[t[1]], outline[t[2]]});
    EXPECT_GE(own * (area(outline) > 0 ? 1 : -1), -1e-6) << what;
    sum += own;
    for (const auto corner : t) is_used[corner] = true;
  }
  EXPECT_NEAR(sum, area(outline), 1e-6 * std::fabs(area(outline))) << what;
  EXPECT_TRUE(std::all_of(is_used.begin(), is_used.end(), [](bool used) { return used; })) << what;
  Vec2d low = outline[0];
  Vec2d high = outline[0];
  for (const Vec2d p : outline) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  for (std::uint64_t i = 0; i < 300; ++i) {
    const Vec2d p{low.x + (high.x - low.x) * unit_random(mix(1, i)),
                  low.y + (high.y - low.y) * unit_random(mix(2, i))};
    int covers = 0;
    for (const auto& t : triangles) covers += winding({outline[t[0]], outline[t[1]], outline[t[2]]}, p);
    ASSERT_EQ(covers, winding(outline, p)) << what << ": (" << p.x << ", " << p.y << ")";
  }
}

// From each first corner, wound either way, in two planes.
void expect_right(const Outline& outline, const std::string& what) {
  for (std::size_t first = 0; first < outline.size(); ++first)
    for (const bool is_backwards : {false, true}) {
      auto turned = turned_by(outline, first);
      if (is_backwards) std::reverse(turned.begin(), turned.end());
      const auto name = what + " from " + std::to_string(first) + (is_backwards ? " backwards" : "");
      const auto made = triangulate(flat(turned));
      EXPECT_FALSE(made.crosses_itself) << name;
      expect_covered_once(turned, made.triangles, name);
      const auto in_space = triangulate(tilted(turned));
      EXPECT_FALSE(in_space.crosses_itself) << name << ", tilted";
      expect_covered_once(turned, in_space.triangles, name + ", tilted");
    }
}

Triangles fan(std::size_t corners) {
  Triangles triangles;
  for (std::uint32_t i = 2; i < corners; ++i) triangles.push_back({0, i - 1, i});
  return triangles;
}

Outline regular(std::size_t corners, double radius) {
  Outline outline;
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = 2 * kPi * static_cast<double>(i) / static_cast<double>(corners);
    outline.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return outline;
}

// Around the origin once, its radii random: simple, and concave almost everywhere.
Outline crown(std::size_t corners, std::uint64_t seed) {
  Outline outline = regular(corners, 1);
  for (std::size_t i = 0; i < corners; ++i) {
    const double radius = 0.1 + unit_random(mix(seed, i));
    outline[i] = {outline[i].x * radius, outline[i].y * radius};
  }
  return outline;
}

Outline comb(int teeth) {
  Outline outline{{0, 0}, {2.0 * teeth - 1, 0}};
  for (int i = teeth; i-- > 0;) {
    outline.insert(outline.end(), {{2.0 * i + 1, 3}, {2.0 * i, 3}});
    if (i > 0) outline.insert(outline.end(), {{2.0 * i, 1}, {2.0 * i - 1, 1}});
  }
  return outline;
}

// A wall of width 1 along a square spiral.
Outline spiral(int turns) {
  Outline outer{{0, 0}};
  Outline inner{{0, 1}};
  Vec2d a{0, 0};
  Vec2d b{0, 1};
  constexpr std::array<Vec2d, 4> kSteps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  for (int i = 0; i < 4 * turns; ++i) {
    const double length = 4.0 * turns - 2 * (i / 2);
    const auto [x, y] = kSteps.at(static_cast<std::size_t>(i % 4));
    a = {a.x + x * length, a.y + y * length};
    b = {b.x + x * (length - (i == 0 ? 1 : 2)), b.y + y * (length - (i == 0 ? 1 : 2))};
    outer.push_back(a);
    inner.push_back(b);
  }
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  return outer;
}

// A flake of Koch (1904): each side has a triangle on its middle third.
Outline snowflake(int levels) {
  Outline outline = regular(3, 1);
  for (; levels > 0; --levels) {
    Outline finer;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2d a = outline[i];
      const Vec2d b = outline[(i + 1) % outline.size()];
      const Vec2d step{(b.x - a.x) / 3, (b.y - a.y) / 3};
      const double height = std::sqrt(3.0) / 2;
      finer.insert(finer.end(), {a, {a.x + step.x, a.y + step.y}});
      finer.push_back({a.x + 1.5 * step.x + height * step.y, a.y + 1.5 * step.y - height * step.x});
      finer.push_back({a.x + 2 * step.x, a.y + 2 * step.y});
    }
    outline = finer;
  }
  return outline;
}

// A square with a hole, joined to it by an edge that is walked forth and back.
Outline frame() { return {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}}; }

// Two holes that hang on one corner, and a third one on the second.
Outline chain_of_holes() {
  return {{0, 0}, {9, 0}, {9, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}, {0, 0},
          {4, 1}, {4, 3}, {5, 3}, {6, 2}, {6, 3}, {7, 3}, {7, 2}, {6, 2}, {5, 1}, {4, 1}};
}

}  // namespace

TEST(Triangulate, ConvexPolygonsStayFansToTheBit) {
  for (std::size_t corners = 3; corners <= 40; ++corners)
    for (std::size_t first = 0; first < corners; first += 3) {
      const auto outline = turned_by(regular(corners, 2.5), first);
      EXPECT_EQ(triangulate(flat(outline)).triangles, fan(corners)) << corners;
      EXPECT_EQ(triangulate(tilted(outline)).triangles, fan(corners)) << corners;
    }
}

// Corners on a side are in line up to the rounding of floats, to either side of it.
TEST(Triangulate, ConvexPolygonsWithCornersOnTheirSidesStayFans) {
  Outline outline;
  const Outline corners = regular(7, 3);
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (int k = 0; k < 5; ++k) {
      const Vec2d a = corners[i];
      const Vec2d b = corners[(i + 1) % corners.size()];
      outline.push_back({a.x + (b.x - a.x) * k / 5, a.y + (b.y - a.y) * k / 5});
    }
  for (std::size_t first = 0; first < outline.size(); ++first) {
    const auto turned = turned_by(outline, first);
    EXPECT_EQ(triangulate(tilted(turned)).triangles, fan(outline.size())) << first;
  }
}

TEST(Triangulate, WarpedConvexQuadrilateralsStayFans) {
  for (const double z : {0.01, 0.2, 0.5, -0.5})
    EXPECT_EQ(triangulate({{0, 0, 0}, {1, 0, z}, {1, 1, 0}, {0, 1, z}}).triangles, fan(4)) << z;
}

TEST(Triangulate, AConcaveQuadrilateralIsCutAtItsConcaveCorner) {
  const Outline dart{{2, 0}, {0.5, 0.5}, {0, 2}, {0, 0}};
  expect_right(dart, "dart");
  // Where the fan is right, it is kept.
  EXPECT_EQ(triangulate(flat(turned_by(dart, 1))).triangles, fan(4));
}

TEST(Triangulate, ConcavePolygonsAreCoveredOnce) {
  expect_right({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}, "L");
  expect_right({{0, 0}, {5, 0}, {5, 5}, {3, 5}, {3, 2}, {2, 2}, {2, 5}, {0, 5}}, "U");
  expect_right(comb(6), "comb");
  expect_right(spiral(3), "spiral");
  expect_right(snowflake(2), "snowflake");
  Outline star = regular(10, 2);
  for (std::size_t i = 0; i < star.size(); i += 2) star[i] = {star[i].x * 0.3, star[i].y * 0.3};
  expect_right(star, "star");
  for (std::uint64_t seed = 0; seed < 20; ++seed) expect_right(crown(5 + seed, seed), "crown");
}

TEST(Triangulate, ASmallNotchFarFromTheFirstCornerIsSeen) {
  expect_right({{0, 0}, {100, 0}, {100, 50}, {99.99, 50.01}, {100, 50.02}, {100, 80}, {0, 80}}, "notch");
}

TEST(Triangulate, CornersInLineAndCornersGivenTwiceAreCovered) {
  expect_right({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {2, 1}, {1, 1}, {1, 2}, {1, 3}, {0, 3}, {0, 1}},
               "in line");
  expect_right({{0, 0}, {0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 1}, {1, 1}, {1, 3}, {0, 3}, {0, 3}}, "twice");
  expect_right({{0, 0}, {4, 0}, {4, 4}, {3, 4}, {3, 6}, {3, 4}, {2, 1}, {1, 4}, {0, 4}}, "spike");
}

TEST(Triangulate, HolesOnADoubledEdgeStayOpen) {
  expect_right(frame(), "frame");
  expect_right(chain_of_holes(), "chain");
}

TEST(Triangulate, PolygonsThatCrossThemselvesStayFansAndSaySo) {
  const Outline bow_tie{{0, 0}, {2, 2}, {2, 0}, {0, 2}};
  const Outline uneven_bow_tie{{0, 0}, {3, 2}, {3, 0}, {0, 1}};
  const Outline pentagram = [] {
    const Outline five = regular(5, 1);
    return Outline{five[0], five[2], five[4], five[1], five[3]};
  }();
  Outline twice_around = regular(5, 1);
  for (const Vec2d p : regular(5, 0.5)) twice_around.push_back(p);
  twice_around.front() = {0, 0.01};
  for (const auto& outline : {bow_tie, uneven_bow_tie, pentagram, twice_around}) {
    const auto made = triangulate(tilted(outline));
    EXPECT_TRUE(made.crosses_itself);
    EXPECT_EQ(made.triangles, fan(outline.size()));
  }
}

TEST(Triangulate, NothingWithoutAreaIsMadeOfNothing) {
  EXPECT_EQ(triangulate({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {2, 0, 0}}).triangles, fan(4));
  EXPECT_FALSE(triangulate({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {2, 0, 0}}).crosses_itself);
  EXPECT_FALSE(triangulate({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}).crosses_itself);
}

TEST(Triangulate, ConcavePolygonsHaveALimitAndConvexOnesHaveNone) {
  EXPECT_EQ(triangulate(flat(regular(20000, 1))).triangles, fan(20000));
  try {
    triangulate(flat(crown(20000, 1)));
    FAIL() << "no error";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(),
                 "a concave face has 20000 corners; at most 16384 are cut into triangles: split it");
  }
}

TEST(Triangulate, ALargeConcavePolygonIsCovered) {
  const Outline outline = crown(3000, 7);
  expect_covered_once(outline, triangulate(flat(outline)).triangles, "large crown");
}
