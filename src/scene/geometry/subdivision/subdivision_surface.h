#pragma once

#include "base/vec.h"
#include "scene/shapes/expression.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

/// Subdivision surfaces of Catmull and Clark (1978, Recursively generated B-spline surfaces on arbitrary
/// topological meshes) as plain data.
namespace orbs::scene {

/// Sharp for ever; a finite sharpness falls by 1 with each step (DeRose, Kass, Truong 1998, Subdivision
/// Surfaces in Character Animation).
constexpr double kInfinitelySharp = std::numeric_limits<double>::infinity();

/// A chain of edges, each from one point to the next, or the points of corners.
struct SharpPoints {
  std::vector<std::uint32_t> points;
  double sharpness = kInfinitelySharp;
  bool operator==(const SharpPoints&) const = default;
};

/// The polygons that a surface is made of: face after face `face_sizes` says how many of `face_points` it
/// takes, counter-clockwise seen from outside.
struct ControlCage {
  std::vector<Vec3d> points_m;
  std::vector<std::uint32_t> face_sizes;
  std::vector<std::uint32_t> face_points;
  std::vector<SharpPoints> creases;
  std::vector<SharpPoints> corners;
  bool operator==(const ControlCage&) const = default;
};

/// The limit point p moves to p + f(p - origin) n, where n is the normal of the limit surface.
struct Displacement {
  Expression expression;
  Vec3d origin_m;
  bool operator==(const Displacement&) const = default;
};

/// Where a mesh comes from that has `levels` steps of subdivision and its vertices on the limit surface.
struct SubdivisionSurface {
  ControlCage cage;
  int levels = 1;
  std::optional<Displacement> displacement;
  bool operator==(const SubdivisionSurface&) const = default;
};

}  // namespace orbs::scene
