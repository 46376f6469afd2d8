#include "scene/geometry/triangulate.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

// Twice the area, along the normal (Newell's method). Relative to a corner, so that far from zero no digits
// are lost.
Vec3d polygon_area(const std::vector<Vec3d>& corners) {
  Vec3d sum;
  for (std::size_t i = 2; i < corners.size(); ++i)
    sum += cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
  return sum;
}

// By how much the rounding of corners to floats moves the area of a fan's triangle: half a unit in the last
// place of each coordinate, times the lengths of the two edges.
std::vector<double> fan_tolerances(const std::vector<Vec3d>& corners) {
  constexpr double kRounding = 0x1p-22;
  double farthest = 0;
  for (const Vec3d corner : corners) farthest = std::max(farthest, largest_magnitude(corner));
  std::vector<double> tolerances;
  for (std::size_t i = 2; i < corners.size(); ++i)
    tolerances.push_back(kRounding * farthest *
                         (length(corners[i - 1] - corners[0]) + length(corners[i] - corners[0])));
  return tolerances;
}

// Whether no triangle of the fan runs backwards by more than rounding explains.
bool fan_runs_forwards(const std::vector<Vec3d>& corners, Vec3d area, const std::vector<double>& tolerances) {
  const double size = length(area);
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const Vec3d part = cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    const double tolerance = tolerances[i - 2];
    if (!(size > 0 ? dot(part, area) >= -tolerance * size : length(part) <= tolerance)) return false;
  }
  return true;
}

// Whether a fan that runs forwards goes more than once around its first corner.
bool fan_overlaps_itself(const std::vector<Vec3d>& corners) {
  constexpr double kOnce_rad = 2 * std::numbers::pi * (1 + 1e-9);
  if (corners.size() < 5) return false;  // each of two triangles has less than half a turn
  double swept_rad = 0;
  for (std::size_t i = 2; i < corners.size(); ++i)
    swept_rad += angle_between(corners[i - 1] - corners[0], corners[i] - corners[0]);
  return swept_rad > kOnce_rad;
}

Triangulation fan(std::size_t corners, bool crosses_itself) {
  Triangulation made{{}, crosses_itself};
  for (std::uint32_t i = 2; i < corners; ++i) made.triangles.push_back({0, i - 1, i});
  return made;
}

// The coordinate along which the area is largest is left out: that keeps the others to the bit.
std::vector<Vec2d> flattened(const std::vector<Vec3d>& corners, Vec3d area) {
  std::vector<Vec2d> flat;
  const Vec3d size{std::fabs(area.x), std::fabs(area.y), std::fabs(area.z)};
  for (const Vec3d p : corners) {
    if (size.x >= size.y && size.x >= size.z)
      flat.push_back(area.x > 0 ? Vec2d{p.y, p.z} : Vec2d{p.z, p.y});
    else if (size.y >= size.z)
      flat.push_back(area.y > 0 ? Vec2d{p.z, p.x} : Vec2d{p.x, p.z});
    else
      flat.push_back(area.z > 0 ? Vec2d{p.x, p.y} : Vec2d{p.y, p.x});
  }
  return flat;
}

// Above 0 where a, b, c turn left.
double turn(Vec2d a, Vec2d b, Vec2d c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

bool cross_each_other(Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
  if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x)) return false;
  if (std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y)) return false;
  return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

bool crosses_itself(const std::vector<Vec2d>& flat) {
  const std::size_t count = flat.size();
  for (std::size_t i = 0; i + 2 < count; ++i)
    for (std::size_t k = i + 2; k < count; ++k)
      if (cross_each_other(flat[i], flat[i + 1], flat[k], flat[(k + 1) % count])) return true;
  return false;
}

// Tips are where a corner lies at the place of a neighbour, or its edges run back on each other, as at the
// end of an edge that is walked forth and back: ears without area. They go first: left behind, they would
// seem to enclose something.
enum class Ear : char { No, Yes, Tip };

// What is left of a polygon, wound to the left, while its ears are clipped: a ring of corners.
struct Ring {
  std::vector<Vec2d> at;
  std::vector<std::uint32_t> next;
  std::vector<std::uint32_t> previous;
  std::vector<Ear> ears;  // as far as is known
  std::uint32_t left = 0;
  std::uint32_t first = 0;  // a corner that is left
};

Ring whole_ring(std::vector<Vec2d> corners) {
  const auto count = static_cast<std::uint32_t>(corners.size());
  Ring ring{std::move(corners), {}, {}, std::vector<Ear>(count), count, 0};
  for (std::uint32_t i = 0; i < count; ++i) {
    ring.next.push_back((i + 1) % count);
    ring.previous.push_back((i + count - 1) % count);
  }
  return ring;
}

double turn_at(const Ring& ring, std::uint32_t corner) {
  return turn(ring.at[ring.previous[corner]], ring.at[corner], ring.at[ring.next[corner]]);
}

// What may be in the way of the triangle that a corner makes with its neighbours.
struct EarTriangle {
  Vec2d a, b, c;  // the corner is b
  Vec2d low, high;
};

EarTriangle ear_triangle(const Ring& ring, std::uint32_t corner) {
  const Vec2d a = ring.at[ring.previous[corner]];
  const Vec2d b = ring.at[corner];
  const Vec2d c = ring.at[ring.next[corner]];
  return {a,
          b,
          c,
          {std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})},
          {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})}};
}

// Whether another corner of the ring is in the way of the triangle. One at the place of a neighbour is not:
// what starts there lies outside, or ends in the triangle with a corner that is in the way. From the place of
// the corner itself, an edge may run through the triangle.
bool is_in_the_way(const Ring& ring, const EarTriangle& ear, std::uint32_t other) {
  const Vec2d p = ring.at[other];
  if (p.x < ear.low.x || p.x > ear.high.x || p.y < ear.low.y || p.y > ear.high.y) return false;
  if (p == ear.a || p == ear.c) return false;
  const auto is_between = [&](Vec2d to) { return turn(ear.b, ear.c, to) > 0 && turn(ear.a, ear.b, to) > 0; };
  if (p == ear.b) return is_between(ring.at[ring.next[other]]) || is_between(ring.at[ring.previous[other]]);
  return turn(ear.a, ear.b, p) >= 0 && turn(ear.b, ear.c, p) >= 0 && turn(ear.c, ear.a, p) >= 0;
}

Ear ear_at(const Ring& ring, std::uint32_t corner) {
  const EarTriangle ear = ear_triangle(ring, corner);
  const auto& [a, b, c, low, high] = ear;
  const double turned = turn(a, b, c);
  if (turned == 0 && (a.x - b.x) * (c.x - b.x) + (a.y - b.y) * (c.y - b.y) >= 0) return Ear::Tip;
  if (!(turned > 0)) return Ear::No;
  const auto before = ring.previous[corner];
  for (auto i = ring.next[ring.next[corner]]; i != before; i = ring.next[i])
    if (is_in_the_way(ring, ear, i)) return Ear::No;
  return Ear::Yes;
}

bool find_ears(Ring& ring) {
  bool is_any = false;
  auto corner = ring.first;
  for (std::uint32_t i = 0; i < ring.left; ++i, corner = ring.next[corner]) {
    ring.ears[corner] = ear_at(ring, corner);
    is_any = is_any || ring.ears[corner] != Ear::No;
  }
  return is_any;
}

// Takes a corner out of the ring. No other corner than its neighbours becomes an ear by that, or ceases to be
// one, where the polygon does not touch itself.
void clip(Ring& ring, std::uint32_t corner, std::vector<std::array<std::uint32_t, 3>>& triangles) {
  const auto before = ring.previous[corner];
  const auto after = ring.next[corner];
  triangles.push_back({before, corner, after});
  ring.next[before] = after;
  ring.previous[after] = before;
  --ring.left;
  ring.first = after;
  for (const auto neighbour : {before, after}) ring.ears[neighbour] = ear_at(ring, neighbour);
}

// Clips what is known to be an ear; whether there was one.
bool clip_known_ear(Ring& ring, std::vector<std::array<std::uint32_t, 3>>& triangles) {
  std::optional<std::uint32_t> found;
  auto corner = ring.first;
  for (std::uint32_t i = 0; i < ring.left; ++i, corner = ring.next[corner]) {
    const Ear ear = ring.ears[corner];
    if (ear == Ear::Tip || (ear == Ear::Yes && !found)) found = corner;
    if (ear == Ear::Tip) break;
  }
  if (found) clip(ring, *found, triangles);
  return found.has_value();
}

// Clips corners in the line of their neighbours, which takes no area away; whether there was one.
bool clip_flat_corners(Ring& ring, std::vector<std::array<std::uint32_t, 3>>& triangles) {
  bool is_any = false;
  auto corner = ring.first;
  for (auto count = ring.left; count > 0 && ring.left > 3; --count) {
    const auto after = ring.next[corner];
    if (turn_at(ring, corner) == 0) {
      clip(ring, corner, triangles);
      is_any = true;
    }
    corner = after;
  }
  return is_any;
}

// Nothing where no ear is left before the end, as happens where edges cross.
std::vector<std::array<std::uint32_t, 3>> clipped_ears(Ring ring) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  find_ears(ring);
  for (int rounds = 0; ring.left > 3;) {
    if (clip_known_ear(ring, triangles)) continue;
    // Where a polygon touches itself, corners that are not neighbours may have become ears. No polygon that
    // was tried takes more than a few rounds; each takes quadratic time.
    constexpr int kMostRounds = 100;
    if (++rounds > kMostRounds || !(find_ears(ring) || clip_flat_corners(ring, triangles))) return {};
  }
  if (!(turn_at(ring, ring.first) >= 0)) return {};
  triangles.push_back({ring.previous[ring.first], ring.first, ring.next[ring.first]});
  return triangles;
}

}  // namespace

Triangulation triangulate(const std::vector<Vec3d>& corners) {
  const std::size_t count = corners.size();
  if (count == 3) return fan(count, false);
  const Vec3d area = polygon_area(corners);
  const auto tolerances = fan_tolerances(corners);
  if (fan_runs_forwards(corners, area, tolerances)) return fan(count, fan_overlaps_itself(corners));
  if (count > kMostConcaveCorners)
    throw InputError(fmt::format("a concave face has {} corners; at most {} are cut into triangles: split it",
                                 count, kMostConcaveCorners));
  // What encloses nothing although triangles of its fan have an area: a bow tie of two equal halves.
  if (length(area) <= std::accumulate(tolerances.begin(), tolerances.end(), 0.0)) return fan(count, true);
  const auto flat = flattened(corners, area);
  if (crosses_itself(flat)) return fan(count, true);
  auto triangles = clipped_ears(whole_ring(flat));
  if (triangles.empty()) return fan(count, true);
  return {std::move(triangles), false};
}

}  // namespace orbs::scene
