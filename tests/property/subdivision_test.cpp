// Subdivision surfaces against uniform cubic B-splines, closed forms and what must not depend on the level.
#include "base/error.h"
#include "property/hashed_numbers.h"
#include "scene/geometry/subdivision/subdivide.h"
#include "scene/geometry/subdivision/tessellate_surface.h"
#include "scene/geometry/subdivision/vertex_ring.h"
#include "scene/shapes/expression.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

using namespace orbs;
using scene::ControlCage;
using scene::SubdivisionSurface;
using scene::SurfaceMesh;
using scene::tessellate;

namespace {

double number_at(std::uint64_t i) { return 2 * static_cast<double>(tests::uniform(i, 0)) - 1; }

// A sheet of n x n squares in x and y from 0 to n; z is random.
ControlCage sheet(int n, double height) {
  ControlCage cage;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      cage.points_m.push_back(
          {static_cast<double>(i), static_cast<double>(j), height * number_at(cage.points_m.size())});
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const auto at = [&](int x, int y) { return static_cast<std::uint32_t>(y * (n + 1) + x); };
      cage.face_sizes.push_back(4);
      cage.face_points.insert(cage.face_points.end(),
                              {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return cage;
}

ControlCage cube() {
  ControlCage cage;
  for (int i = 0; i < 8; ++i)
    cage.points_m.push_back({i % 2 == 0 ? -1.0 : 1.0, i / 2 % 2 == 0 ? -1.0 : 1.0, i / 4 == 0 ? -1.0 : 1.0});
  cage.face_sizes.assign(6, 4);
  cage.face_points = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
  return cage;
}

ControlCage sharp_box() {
  auto box = cube();
  box.creases = {{{0, 1, 3, 2, 0}}, {{4, 5, 7, 6, 4}}, {{0, 4}}, {{1, 5}}, {{2, 6}}, {{3, 7}}};
  return box;
}

// A pentagonal prism with a roof of triangles, all points moved at random: faces of 3, 4 and 5 points, points
// of valence 3, 4 and 5.
ControlCage prism() {
  ControlCage cage;
  for (std::uint32_t i = 0; i < 11; ++i) {
    const double angle = 2 * std::numbers::pi * (i % 5) / 5;
    const double r = i == 10 ? 0 : 1;
    cage.points_m.push_back({r * std::cos(angle), r * std::sin(angle), i / 5 == 0 ? 0.0 : 1.5 * (i / 5)});
    cage.points_m.back() += 0.2 * Vec3d{number_at(3 * i), number_at(3 * i + 1), number_at(3 * i + 2)};
  }
  cage.face_sizes = {5};
  cage.face_points = {4, 3, 2, 1, 0};
  for (std::uint32_t i = 0; i < 5; ++i) {
    const std::uint32_t next = (i + 1) % 5;
    cage.face_sizes.insert(cage.face_sizes.end(), {4, 3});
    cage.face_points.insert(cage.face_points.end(), {i, next, next + 5, i + 5, i + 5, next + 5, 10});
  }
  return cage;
}

// Its bottom ring is a crease, an edge of the roof a dart, an upright edge a crease of sharpness 2.
ControlCage creased_prism() {
  auto cage = prism();
  cage.creases.push_back({{0, 1, 2, 3, 4, 0}, scene::kInfinitelySharp});
  cage.creases.push_back({{6, 10}, scene::kInfinitelySharp});
  return cage;
}

SurfaceMesh surface(const ControlCage& cage, int levels) { return tessellate({cage, levels, {}}); }

struct Basis {
  std::array<double, 4> value;
  std::array<double, 4> slope;
};

// Uniform cubic B-splines at t in [0, 1] (de Boor 1978, A Practical Guide to Splines).
Basis b_spline(double t) {
  const double s = 1 - t;
  return {{s * s * s / 6, (3 * t * t * t - 6 * t * t + 4) / 6, (3 * s * s * s - 6 * s * s + 4) / 6,
           t * t * t / 6},
          {-s * s / 2, (3 * t * t - 4 * t) / 2, (4 * s - 3 * s * s) / 2, t * t / 2}};
}

Vec3d curve(const std::vector<Vec3d>& closed, double t) {
  const auto n = closed.size();
  const auto first = static_cast<std::size_t>(t);
  const auto basis = b_spline(t - static_cast<double>(first));
  Vec3d sum;
  for (std::size_t k = 0; k < 4; ++k) sum += closed[(first + k + n - 1) % n] * basis.value[k];
  return sum;
}

// Distance of the nearest vertex.
double distance_to(const SurfaceMesh& mesh, Vec3d p) {
  double nearest = 1e300;
  for (const Vec3d q : mesh.places_m) nearest = std::min(nearest, length(p - q));
  return nearest;
}

// The curve must pass through vertices at all its parameters that are multiples of 1 / steps.
void expect_curve(const SurfaceMesh& mesh, const std::vector<Vec3d>& closed, int steps) {
  for (int i = 0; i < steps * static_cast<int>(closed.size()); ++i)
    EXPECT_LT(distance_to(mesh, curve(closed, static_cast<double>(i) / steps)), 1e-12) << i;
}

std::vector<Vec3d> points_of(const ControlCage& cage, const std::vector<std::uint32_t>& indices) {
  std::vector<Vec3d> points;
  for (const auto i : indices) points.push_back(cage.points_m[i]);
  return points;
}

// Every edge of triangles, by the places of its ends, has one triangle on each side.
bool is_closed(const SurfaceMesh& mesh) {
  using Place = std::array<double, 3>;
  std::set<std::pair<Place, Place>> edges;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3d a = mesh.places_m[t[k]];
      const Vec3d b = mesh.places_m[t[(k + 1) % 3]];
      if (!edges.insert({{a.x, a.y, a.z}, {b.x, b.y, b.z}}).second) return false;
    }
  for (const auto& [a, b] : edges)
    if (!edges.contains({b, a})) return false;
  return true;
}

double volume(const SurfaceMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles)
    sum += dot(mesh.places_m[t[0]], cross(mesh.places_m[t[1]], mesh.places_m[t[2]])) / 6;
  return sum;
}

scene::Displacement displacement(const std::string& text) { return {scene::parse_expression(text), {}}; }

}  // namespace

// Splines of even knots reproduce x and y, so that these are the parameters of a point. The two outermost
// rows of squares feel the boundary.
TEST(Subdivision, RegularCagesAreBicubicBSplines) {
  const auto cage = sheet(7, 1);
  const auto mesh = surface(cage, 3);
  int seen = 0;
  for (std::size_t v = 0; v < mesh.places_m.size(); ++v) {
    const Vec3d p = mesh.places_m[v];
    if (!(p.x > 1.01 && p.x < 5.99 && p.y > 1.01 && p.y < 5.99)) continue;
    const auto i = static_cast<std::size_t>(p.x + 1e-9);
    const auto j = static_cast<std::size_t>(p.y + 1e-9);
    const auto u = b_spline(p.x - static_cast<double>(i));
    const auto w = b_spline(p.y - static_cast<double>(j));
    double z = 0;
    double dx = 0;
    double dy = 0;
    for (std::size_t b = 0; b < 4; ++b)
      for (std::size_t a = 0; a < 4; ++a) {
        const double point = cage.points_m[(j + b - 1) * 8 + i + a - 1].z;
        z += point * u.value[a] * w.value[b];
        dx += point * u.slope[a] * w.value[b];
        dy += point * u.value[a] * w.slope[b];
      }
    EXPECT_NEAR(p.z, z, 1e-12);
    EXPECT_LT(length(mesh.normals[v] - normalised(Vec3d{-dx, -dy, 1})), 1e-12);
    ++seen;
  }
  EXPECT_EQ(seen, 39 * 39);
}

// From one level to the next the vertices stay where they are, and so do the normals; the sheet and the prism
// have all rules but those of corners with several faces between sharp edges, which have no tangent plane.
TEST(Subdivision, LimitDoesNotDependOnTheLevel) {
  for (const auto& cage : {sheet(3, 1), cube(), prism(), creased_prism()}) {
    const auto coarse = surface(cage, 1);
    const auto fine = surface(cage, 4);
    for (std::size_t v = 0; v < coarse.places_m.size(); ++v) {
      EXPECT_LT(distance_to(fine, coarse.places_m[v]), 1e-12);
      double nearest = 2;
      for (std::size_t w = 0; w < fine.places_m.size(); ++w)
        if (length(fine.places_m[w] - coarse.places_m[v]) < 1e-9)
          nearest = std::min(nearest, length(fine.normals[w] - coarse.normals[v]));
      EXPECT_LT(nearest, 1e-9) << v;
    }
  }
}

TEST(Subdivision, ClosedFormsAreWhatTheStepsConvergeTo) {
  for (std::size_t n = 3; n <= 12; ++n) {
    scene::VertexRing ring;
    for (std::size_t i = 0; i < n; ++i) {
      const auto at = [&](double turn) {
        const double angle = 2 * std::numbers::pi * turn / static_cast<double>(n);
        return Vec3d{std::cos(angle), std::sin(angle), 0} +
               0.3 * Vec3d{number_at(n * 99 + i), number_at(n * 98 + i), number_at(n * 97 + i)};
      };
      ring.edge_ends_m.push_back(at(static_cast<double>(i)));
      ring.opposite_m.push_back(1.4 * at(static_cast<double>(i) + 0.5));
    }
    ring.is_sharp.assign(n, false);
    const auto closed = scene::limit_of(ring);
    const auto steps = scene::limit_by_steps(ring, 120);
    EXPECT_LT(length(closed.point_m - steps.point_m), 1e-13) << n;
    EXPECT_LT(length(closed.normals.front() - steps.normals.front()), 1e-6) << n;
  }
}

// Steps and masks by hand: the point (1, 1, 1) goes to 5/9 and its limit is 1/2; the middle of a face, after
// one step a point of valence 4, goes to (16 + 4 * 4 * 3/4 + 4 * 5/9) / 36.
TEST(Subdivision, CubeHasItsSymmetriesAndKnownPoints) {
  const auto mesh = surface(cube(), 3);
  EXPECT_LT(distance_to(mesh, {0.5, 0.5, 0.5}), 1e-15);
  EXPECT_LT(distance_to(mesh, {(16 + 12 + 20.0 / 9) / 36, 0, 0}), 1e-15);
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_GT(volume(mesh), 0);
  const std::size_t edges = mesh.triangles.size() * 3 / 2;
  EXPECT_EQ(mesh.places_m.size() + mesh.triangles.size(), edges + 2);
  for (std::size_t v = 0; v < mesh.places_m.size(); ++v) {
    const Vec3d p = mesh.places_m[v];
    EXPECT_LT(largest_magnitude(p), 1);
    EXPECT_GT(dot(p, mesh.normals[v]), 0);
    for (const Vec3d q : {Vec3d{-p.x, p.y, p.z}, Vec3d{p.y, p.z, p.x}, Vec3d{p.y, p.x, p.z}})
      EXPECT_LT(distance_to(mesh, q), 1e-14);
  }
}

TEST(Subdivision, BoundariesAndSharpCreasesAreCubicBSplines) {
  const auto flat = sheet(3, 1);
  expect_curve(surface(flat, 2), points_of(flat, {0, 1, 2, 3, 7, 11, 15, 14, 13, 12, 8, 4}), 4);
  const auto cage = creased_prism();
  expect_curve(surface(cage, 3), points_of(cage, {0, 1, 2, 3, 4}), 8);
  EXPECT_TRUE(is_closed(surface(cage, 3)));
}

TEST(Subdivision, CornersStayWhereTheyAre) {
  auto cage = sheet(3, 1);
  cage.corners.push_back({{0, 3, 5}, scene::kInfinitelySharp});
  const auto mesh = surface(cage, 2);
  for (const std::size_t i : {0U, 3U, 5U}) EXPECT_LT(distance_to(mesh, cage.points_m[i]), 1e-15);
  EXPECT_GT(distance_to(mesh, cage.points_m[12]), 0.1);
  // A box whose edges are all sharp is itself.
  const auto sharp = surface(sharp_box(), 2);
  EXPECT_NEAR(volume(sharp), 8, 1e-12);
  for (std::size_t v = 0; v < sharp.places_m.size(); ++v)
    EXPECT_NEAR(dot(sharp.places_m[v], sharp.normals[v]), 1, 1e-12);
}

// A sharpness of 1 is infinite for one step, and one below 1 lies evenly between that and none.
TEST(Subdivision, SharpnessLastsAsManySteps) {
  const auto stepped = [](double sharpness) {
    auto cage = creased_prism();
    cage.creases[0].sharpness = sharpness;
    return subdivide(connect(cage));
  };
  const auto none = stepped(0);
  const auto half = stepped(0.25);
  const auto one = stepped(1);
  const auto forever = stepped(scene::kInfinitelySharp);
  double largest = 0;
  for (std::size_t i = 0; i < one.points_m.size(); ++i) {
    EXPECT_LT(length(one.points_m[i] - forever.points_m[i]), 1e-15);
    EXPECT_LT(length(half.points_m[i] - (0.75 * none.points_m[i] + 0.25 * one.points_m[i])), 1e-15);
    largest = std::max(largest, length(one.points_m[i] - none.points_m[i]));
  }
  EXPECT_GT(largest, 0.1);
  const auto twice = subdivide(stepped(2));
  const auto twice_forever = subdivide(forever);
  for (std::size_t i = 0; i < twice.points_m.size(); ++i)
    EXPECT_LT(length(twice.points_m[i] - twice_forever.points_m[i]), 1e-15);
  EXPECT_EQ(
      std::count_if(twice.edge_sharpness.begin(), twice.edge_sharpness.end(), [](double s) { return s > 0; }),
      4);  // the dart, in four parts
}

TEST(Subdivision, MovesWithItsCage) {
  const auto motion = [](Vec3d p) { return Vec3d{2 * p.x + p.y - 3, p.z - 0.5 * p.x, p.y + 0.25 * p.z + 1}; };
  auto cage = creased_prism();
  const auto before = surface(cage, 3);
  for (Vec3d& p : cage.points_m) p = motion(p);
  const auto after = surface(cage, 3);
  for (std::size_t v = 0; v < before.places_m.size(); ++v)
    EXPECT_LT(length(after.places_m[v] - motion(before.places_m[v])), 1e-13);
}

TEST(Subdivision, ConstantDisplacementIsAnOffset) {
  const auto plain = surface(cube(), 4);
  const auto offset = tessellate({cube(), 4, displacement("0.125")});
  double largest = 0;
  for (std::size_t v = 0; v < plain.places_m.size(); ++v) {
    EXPECT_LT(length(offset.places_m[v] - plain.places_m[v] - 0.125 * plain.normals[v]), 1e-14);
    largest = std::max(largest, length(offset.normals[v] - plain.normals[v]));
  }
  // An offset surface has the normals of the surface: what is left is that of triangles.
  EXPECT_LT(largest, 0.01);
  EXPECT_GT(volume(offset), volume(plain));
}

// z = 0.1 sin(3 x) on a plane, in coordinates about the displacement's origin; normals by its derivative.
TEST(Subdivision, DisplacementFollowsItsFormula) {
  for (const int levels : {3, 4, 5}) {
    SubdivisionSurface plane{sheet(4, 0), levels, displacement("0.1 * sin(3 * x)")};
    plane.displacement->origin_m = {2, 0, 0};
    const auto mesh = tessellate(plane);
    double largest = 0;
    for (std::size_t v = 0; v < mesh.places_m.size(); ++v) {
      const Vec3d p = mesh.places_m[v];
      EXPECT_NEAR(p.z, 0.1 * std::sin(3 * (p.x - 2)), 1e-14);
      if (p.x < 1 || p.x > 3 || p.y < 1 || p.y > 3) continue;
      const Vec3d expected = normalised(Vec3d{-0.3 * std::cos(3 * (p.x - 2)), 0, 1});
      largest = std::max(largest, length(mesh.normals[v] - expected));
    }
    const double edge = std::exp2(-levels);
    EXPECT_LT(largest, 1.5 * edge * edge);  // 2.7 / 2 is the third derivative's share
    EXPECT_GT(largest, 0.05 * edge * edge);
  }
}

// On the faces of a box whose edges are all sharp, along its edges by the mean of two normals, at its corners
// by that of three.
TEST(Subdivision, CreasesMoveAlongTheMeanOfTheirNormals) {
  const auto mesh = tessellate({sharp_box(), 1, displacement("0.5")});
  EXPECT_LT(distance_to(mesh, {0, 0, 1.5}), 1e-14);
  EXPECT_LT(distance_to(mesh, {0, 1 + 0.5 / std::sqrt(2), 1 + 0.5 / std::sqrt(2)}), 1e-14);
  const double corner = 1 + 0.5 / std::sqrt(3);
  EXPECT_LT(distance_to(mesh, {corner, corner, corner}), 1e-14);
}

TEST(Subdivision, DisplacementLeavesCreasesClosed) {
  const auto mesh = tessellate({creased_prism(), 4, displacement("0.05 * sin(9 * x) * cos(7 * y)")});
  EXPECT_TRUE(is_closed(mesh));
  for (const Vec3d n : mesh.normals) EXPECT_NEAR(length(n), 1, 1e-12);
}
