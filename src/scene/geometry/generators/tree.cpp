#include "scene/geometry/generators/tree.h"

#include "scene/geometry/mesh.h"

#include <cmath>
#include <numbers>

namespace orbs::scene {

namespace {

constexpr int kTrunkSides = kTreeTrunkTriangles / 2;
constexpr double kTrunkRadius = 0.08;  // of the tree's radius
constexpr double kFirstBranch = 0.15;  // of the tree's height
constexpr double kNotchRadius = 0.72;  // of the tips' radius
constexpr double kNotchLift = 0.03;    // of the tree's height: tips hang lower than the notches between them
constexpr double kTierOverlap = 0.6;   // of the height of a tier, hidden in the tier above

Vec3d on_circle(double turn, double radius_m, double height_m) {
  const double angle_rad = 2 * std::numbers::pi * turn;
  return {radius_m * std::sin(angle_rad), height_m, radius_m * std::cos(angle_rad)};
}

void add_facet(Mesh& mesh, const std::array<Vec3d, 3>& corners, const std::array<Vec2d, 3>& uvs) {
  const Vec3d normal = normalised(cross(corners[1] - corners[0], corners[2] - corners[0]));
  const std::uint32_t first = vertex_count(mesh);
  for (std::size_t i = 0; i < 3; ++i) add_vertex(mesh, corners[i], normal, uvs[i]);
  mesh.triangles.push_back({first, first + 1, first + 2});
}

void add_trunk(Mesh& mesh, double radius_m, double height_m) {
  for (int side = 0; side < kTrunkSides; ++side) {
    const double from = double(side) / kTrunkSides;
    const double to = double(side + 1) / kTrunkSides;
    const Vec3d a = on_circle(from, radius_m, 0);
    const Vec3d b = on_circle(to, radius_m, 0);
    const Vec3d c = on_circle(to, radius_m / 2, height_m);
    const Vec3d d = on_circle(from, radius_m / 2, height_m);
    add_facet(mesh, {a, b, c}, {Vec2d{from, 0}, Vec2d{to, 0}, Vec2d{to, 1}});
    add_facet(mesh, {a, c, d}, {Vec2d{from, 0}, Vec2d{to, 1}, Vec2d{from, 1}});
  }
}

struct Tier {
  double bottom_m;
  double top_m;
  double radius_m;
  double lift_m;
  double twist;  // turns
};

void add_tier(Mesh& mesh, const Tier& tier, int points) {
  const Vec3d top{0, tier.top_m, 0};
  const Vec3d below{0, tier.bottom_m + tier.lift_m, 0};
  const auto rim = [&](int k) {
    const double turn = tier.twist + 0.5 * k / points;
    return k % 2 == 0 ? on_circle(turn, tier.radius_m, tier.bottom_m)
                      : on_circle(turn, tier.radius_m * kNotchRadius, tier.bottom_m + tier.lift_m);
  };
  for (int k = 0; k < 2 * points; ++k) {
    const Vec3d a = rim(k);
    const Vec3d b = rim((k + 1) % (2 * points));
    const double from = 0.5 * k / points;
    const double to = 0.5 * (k + 1) / points;
    const double middle = (from + to) / 2;
    add_facet(mesh, {a, b, top}, {Vec2d{from, 0}, Vec2d{to, 0}, Vec2d{middle, 1}});
    add_facet(mesh, {b, a, below}, {Vec2d{to, 0}, Vec2d{from, 0}, Vec2d{middle, 1}});
  }
}

}  // namespace

Mesh make_tree(const TreeParameters& parameters) {
  const double height_m = parameters.height_m;
  const double first_m = kFirstBranch * height_m;
  const double step_m = (height_m - first_m) / (parameters.tiers + kTierOverlap);
  Mesh mesh;
  add_trunk(mesh, kTrunkRadius * parameters.radius_m, first_m + step_m);
  for (int i = 0; i < parameters.tiers; ++i) {
    const double share = 1 - double(i) / (parameters.tiers + 1);
    const double golden_turn = i * (std::numbers::phi - 1);  // no tip stands above the tip of a lower tier
    const double bottom_m = first_m + i * step_m;
    add_tier(mesh,
             {bottom_m, bottom_m + (1 + kTierOverlap) * step_m, parameters.radius_m * share,
              kNotchLift * height_m, golden_turn},
             parameters.points);
  }
  return mesh;
}

}  // namespace orbs::scene
