#include "scene/geometry/placed_vertices.h"

#include <algorithm>
#include <cmath>

namespace orbs::scene {

namespace {

struct Extent {
  Vec3d low, high;
};

Extent extent_of(const std::vector<Vec3d>& vertices) {
  Extent out{vertices.front(), vertices.front()};
  for (const Vec3d v : vertices) {
    out.low = {std::fmin(out.low.x, v.x), std::fmin(out.low.y, v.y), std::fmin(out.low.z, v.z)};
    out.high = {std::fmax(out.high.x, v.x), std::fmax(out.high.y, v.y), std::fmax(out.high.z, v.z)};
  }
  return out;
}

Vec3d origin_of(const std::vector<Vec3d>& vertices) {
  constexpr double kMostExtents = 64;
  if (vertices.empty()) return {};
  const auto [low, high] = extent_of(vertices);
  const double extent = largest_magnitude(high - low);
  const double farthest = std::fmax(largest_magnitude(low), largest_magnitude(high));
  // Also false if a number is not finite: the check of the mesh says so.
  if (!(extent > 0 && farthest > kMostExtents * extent && std::isfinite(farthest))) return {};
  // A multiple of a power of two, so that the same mesh at places that differ by such multiples becomes the
  // same floats.
  const double step = std::exp2(std::ceil(std::log2(extent)));
  const auto nearest = [&](double m) { return step * std::round(m / step); };
  const Vec3d middle = (low + high) * 0.5;
  return {nearest(middle.x), nearest(middle.y), nearest(middle.z)};
}

}  // namespace

PlacedVertices placed_vertices(const std::vector<Vec3d>& vertices) {
  PlacedVertices out{{}, origin_of(vertices)};
  out.positions.reserve(vertices.size());
  for (const Vec3d v : vertices) out.positions.push_back(cast<float>(v - out.origin_m));
  return out;
}

}  // namespace orbs::scene
