// Points beside an edge where another triangle rises: what leaves them starts before that triangle.
#include "tracer/world/edge_distance.h"

#include "base/random.h"
#include "tracer/world/surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

using namespace orbs;
using namespace orbs::tracer;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

// Two triangles that meet at an edge, as a wedge of empty space between them.
struct Wedge {
  Vec3f corner;  // an end of the edge
  Vec3f edge;
  Vec3f to_third;
  Vec3d other_normal;  // of the other triangle, into the wedge
};

Vec3d random_direction(std::uint64_t at) {
  const double z = 2 * unit_random(mix(at, 1)) - 1;
  const double turn = 2 * std::numbers::pi * unit_random(mix(at, 2));
  return {std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z};
}

Wedge wedge_of(double angle_deg, std::uint64_t at) {
  const Vec3d along = random_direction(mix(at, 3));
  const Vec3d inwards = normalised(cross(along, random_direction(mix(at, 4))));
  const Vec3d normal = cross(along, inwards);
  const double length = 0.05 + unit_random(mix(at, 5));
  const double height = 0.05 + unit_random(mix(at, 6));
  const double angle = angle_deg * kDegree;
  return {cast<float>(random_direction(mix(at, 7))), cast<float>(along * length),
          cast<float>(along * (length * unit_random(mix(at, 8))) + inwards * height),
          inwards * std::sin(angle) - normal * std::cos(angle)};
}

// The distance, in position errors, of what leaves the wedge's triangle from the plane of the other one.
// `share`: of the height, by which the hit lies off the edge.
double distance_before_the_other(const Wedge& wedge, double along, double share, bool keeps_distance) {
  const Vec2f barycentric{static_cast<float>((1 - share) * along), static_cast<float>(share)};
  const float error = 12 * 0x1p-24F;
  const Vec2f change =
      keeps_distance ? away_from_edges(barycentric, wedge.edge, wedge.to_third, error) : Vec2f{};
  const Vec3f position =
      wedge.corner + wedge.edge * (barycentric.x + change.x) + wedge.to_third * (barycentric.y + change.y);
  const Vec3f normal = normalised(cross(wedge.edge, wedge.to_third));
  const Vec3f origin = offset_origin(position, error, normal, normal);
  return dot(cast<double>(origin - wedge.corner), wedge.other_normal) / static_cast<double>(error);
}

double least_distance(bool keeps_distance) {
  double least = std::numeric_limits<double>::infinity();
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const double angle = 16 + 160 * unit_random(mix(i, 9));
    const double share = std::pow(10, -7 + 6 * unit_random(mix(i, 10)));
    least = std::min(
        least, distance_before_the_other(wedge_of(angle, i), unit_random(mix(i, 11)), share, keeps_distance));
  }
  return least;
}

}  // namespace

TEST(EdgeDistance, WhatLeavesAWedgeStartsInIt) {
  EXPECT_LT(least_distance(false), -1) << "else there is nothing to be done";
  EXPECT_GT(least_distance(true), 0.5);
}

TEST(EdgeDistance, IsKeptFromAllEdgesAndMovesNothingElse) {
  const Vec3f e1{1, 0, 0};
  const Vec3f e2{0.3F, 0.8F, 0};
  constexpr float kError = 1e-6F;
  EXPECT_EQ(away_from_edges({0.3F, 0.3F}, e1, e2, kError), Vec2f{});
  EXPECT_EQ(away_from_edges({0.3F, 1e-4F}, e1, e2, kError), Vec2f{}) << "farther off than that";
  for (const Vec2f hit :
       {Vec2f{0, 0}, Vec2f{1, 0}, Vec2f{0, 1}, Vec2f{0.5F, 0}, Vec2f{0.5F, 0.5F}, Vec2f{0, 0.2F}}) {
    const Vec2f change = away_from_edges(hit, e1, e2, kError);
    const Vec3f at = e1 * (hit.x + change.x) + e2 * (hit.y + change.y);
    const float from_e1 = at.y;
    const float from_e2 = (e2.y * at.x - e2.x * at.y) / length(e2);
    const Vec3f third = e2 - e1;
    const float from_third = (third.x * at.y - third.y * (at.x - 1)) / -length(third);
    for (const float distance : {from_e1, from_e2, -from_third})
      EXPECT_GT(std::abs(distance), 0.99F * kEdgeDistance * kError) << hit.x << ", " << hit.y;
    EXPECT_LT(largest_magnitude(at - e1 * hit.x - e2 * hit.y), 5 * kEdgeDistance * kError);
  }
}

// Far from the origin the rounding is larger than the triangle, which is no reason to look all alike.
TEST(EdgeDistance, IsAThousandthOfTheTriangleAtMost) {
  const Vec3f e1{1, 0, 0};
  const Vec3f e2{0, 1, 0};
  const Vec2f change = away_from_edges({0, 0}, e1, e2, 1);
  EXPECT_LT(std::max(std::abs(change.x), std::abs(change.y)), 2 * kMostOfHeight);
  EXPECT_EQ(away_from_edges({0.25F, 0.25F}, e1, e2, 1), Vec2f{});
  EXPECT_EQ(away_from_edges({0, 0}, e1, e1, 1e-6F), Vec2f{}) << "a triangle without area has no distances";
}
