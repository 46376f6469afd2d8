// CSG by single hits against exact set operations on the lists of intervals that a ray has in each operand.
#include "tracer/shapes/csg.h"

#include "tracer/shapes/build_solids.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

using orbs::Mat4;
using orbs::Vec3d;
using orbs::scene::BoxForm;
using orbs::scene::CsgForm;
using orbs::scene::HalfSpaceForm;
using orbs::scene::SetOperation;
using orbs::scene::Shape;
using orbs::tracer::BoundaryHit;
using orbs::tracer::Crossing;
using orbs::tracer::make_solid;
using orbs::tracer::Solid;

namespace {

// The ends of the intervals in which the x axis lies inside, in order; an interval without end ends at +-inf.
using Ends = std::vector<double>;

bool holds(const Ends& ends, double x) {
  return (std::upper_bound(ends.begin(), ends.end(), x) - ends.begin()) % 2 == 1;
}

bool combine(SetOperation operation, bool a, bool b) {
  if (operation == SetOperation::Union) return a || b;
  return operation == SetOperation::Intersection ? a && b : a && !b;
}

// Regularised: an end is one of the result where the result differs on its two sides.
Ends combined(SetOperation operation, const Ends& a, const Ends& b) {
  Ends all = a;
  all.insert(all.end(), b.begin(), b.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  const auto inside = [&](double x) { return combine(operation, holds(a, x), holds(b, x)); };
  Ends result;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double before = i == 0 ? all[i] - 1 : (all[i - 1] + all[i]) / 2;
    const double behind = i + 1 == all.size() ? all[i] + 1 : (all[i] + all[i + 1]) / 2;
    if (inside(before) != inside(behind)) result.push_back(all[i]);
  }
  return result;
}

struct Case {
  Shape shape;
  Ends ends;
};

Case random_box(std::mt19937& random, bool on_grid) {
  std::uniform_real_distribution<double> even(0, 12);
  double low = even(random);
  double high = even(random);
  if (on_grid) {
    low = std::floor(low);
    high = std::floor(high);
  }
  if (low == high) high += 1;
  if (low > high) std::swap(low, high);
  Shape shape{"", BoxForm{{(high - low) / 2, 1, 1}}, orbs::translation({(low + high) / 2, 0, 0}), 0};
  return {shape, {low, high}};
}

Case random_tree(std::mt19937& random, int depth, bool on_grid) {
  if (depth == 0) return random_box(random, on_grid);
  const auto operation = static_cast<SetOperation>(random() % 3);
  Case a = random_tree(random, depth - 1, on_grid);
  Case b =
      random_tree(random, depth - 1 - static_cast<int>(random() % static_cast<unsigned>(depth)), on_grid);
  return {{"", CsgForm{operation, {a.shape, b.shape}}, {}, 0}, combined(operation, a.ends, b.ends)};
}

// All boundaries beyond the start, along +x.
Ends boundaries(const Solid& solid, double start) {
  Ends found;
  double t = 0;
  for (int i = 0; i < 100; ++i) {
    const BoundaryHit next = next_boundary(solid, {{start, 0.1, 0.2}, {1, 0, 0}}, t);
    if (std::isinf(next.t)) break;
    found.push_back(start + next.t);
    t = orbs::tracer::past({{start, 0.1, 0.2}, {1, 0, 0}}, next.t);
  }
  return found;
}

// Number of trees whose boundaries differ from the exact ones.
int wrong_trees(bool on_grid, int trees) {
  std::mt19937 random(on_grid ? 5 : 6);
  int wrong = 0;
  for (int i = 0; i < trees; ++i) {
    const Case tree = random_tree(random, 1 + i % 5, on_grid);
    const Solid solid = make_solid(tree.shape, {});
    // Starts outside of all, and at half numbers inside and between.
    for (const double start : {-3.0, 2.6, 6.55}) {
      Ends expected;
      for (const double end : tree.ends)
        if (end > start) expected.push_back(end);
      const Ends found = boundaries(solid, start);
      const bool same = std::equal(found.begin(), found.end(), expected.begin(), expected.end(),
                                   [](double a, double b) { return std::abs(a - b) < 1e-9; });
      wrong += same ? 0 : 1;
    }
    EXPECT_EQ(solid.counts->unfinished, 0U);
  }
  return wrong;
}

Shape box(double low, double high) {
  return {"", BoxForm{{(high - low) / 2, 1, 1}}, orbs::translation({(low + high) / 2, 0, 0}), 0};
}
Shape csg(SetOperation operation, std::vector<Shape> operands) {
  return {"", CsgForm{operation, std::move(operands)}, {}, 0};
}

}  // namespace

TEST(Csg, RandomTreesHaveTheExactBoundaries) { EXPECT_EQ(wrong_trees(false, 4000), 0); }

TEST(Csg, RandomTreesWithCoincidentFacesHaveTheExactBoundaries) { EXPECT_EQ(wrong_trees(true, 4000), 0); }

// Inside both, the printed table of unions takes the farther exit: 10 instead of 12.
TEST(Csg, AnOperandMayBeginAgainBeforeTheOtherOneEnds) {
  const auto a = csg(SetOperation::Union, {box(0, 5), box(8, 12)});
  const auto solid = make_solid(csg(SetOperation::Union, {a, box(2, 10)}), {});
  EXPECT_EQ(boundaries(solid, 3), (Ends{12}));
  const auto nearer = make_solid(csg(SetOperation::Union, {a, box(2, 7)}), {});
  EXPECT_EQ(boundaries(nearer, 3), (Ends{7, 8, 12}));
}

TEST(Csg, CoincidentFacesLeaveNothingBehind) {
  EXPECT_EQ(boundaries(make_solid(csg(SetOperation::Union, {box(0, 5), box(5, 9)}), {}), 1), (Ends{9}));
  EXPECT_EQ(boundaries(make_solid(csg(SetOperation::Difference, {box(0, 5), box(0, 3)}), {}), -1),
            (Ends{3, 5}));
  EXPECT_EQ(boundaries(make_solid(csg(SetOperation::Intersection, {box(0, 5), box(5, 9)}), {}), 1), (Ends{}));
  EXPECT_EQ(boundaries(make_solid(csg(SetOperation::Union, {box(0, 5), box(2, 5)}), {}), 3), (Ends{5}));
}

// Turned and moved, the two faces differ in the last digits.
TEST(Csg, CoincidentFacesOfTurnedSolidsLeaveNothingBehind) {
  const Mat4 turn = orbs::rotation_y(37) * orbs::rotation_x(-11) * orbs::translation({0.3, 0.1, 0.7});
  Shape pair = csg(SetOperation::Union, {box(0, 5), box(5, 9)});
  pair.matrix = turn;
  const Solid solid = make_solid(pair, {});
  std::mt19937 random(3);
  std::uniform_real_distribution<double> even(-0.9, 0.9);
  for (int i = 0; i < 1000; ++i) {
    const Vec3d from = transform_point(turn, {-4, even(random), even(random)});
    const Vec3d to = transform_point(turn, {12, even(random) / 2, even(random) / 2});
    const orbs::tracer::SolidRay ray{from, to - from};
    const BoundaryHit enter = next_boundary(solid, ray, 0);
    ASSERT_EQ(enter.crossing, Crossing::Enter);
    const BoundaryHit exit = next_boundary(solid, ray, past(ray, enter.t));
    ASSERT_EQ(exit.crossing, Crossing::Exit);
    const Vec3d end = transform_point(*inverse(turn), from + (to - from) * exit.t);
    ASSERT_GT(end.x, 5.5) << "the face between the boxes at x = 5 was hit";
  }
}

TEST(Csg, HalfSpacesCutWithoutAnEnd) {
  // Below y = 0 turned to x < 4.
  Shape half{"", HalfSpaceForm{}, orbs::translation({4, 0, 0}) * orbs::rotation_z(-90), 0};
  EXPECT_EQ(boundaries(make_solid(csg(SetOperation::Intersection, {box(0, 9), half}), {}), -1).size(), 2U);
  EXPECT_NEAR(boundaries(make_solid(csg(SetOperation::Intersection, {box(0, 9), half}), {}), -1)[1], 4,
              1e-12);
  EXPECT_NEAR(boundaries(make_solid(csg(SetOperation::Difference, {box(0, 9), half}), {}), -1)[0], 4, 1e-12);
}

// From inside a difference the normal of what was taken away points into the solid that is left.
TEST(Csg, NormalsOfWhatIsTakenAwayAreTurned) {
  const auto solid = make_solid(csg(SetOperation::Difference, {box(0, 9), box(3, 5)}), {});
  const BoundaryHit into_hole = next_boundary(solid, {{1, 0, 0}, {1, 0, 0}}, 0);
  EXPECT_NEAR(into_hole.t, 2, 1e-12);
  EXPECT_EQ(into_hole.crossing, Crossing::Exit);
  EXPECT_TRUE(into_hole.is_flipped);
}
