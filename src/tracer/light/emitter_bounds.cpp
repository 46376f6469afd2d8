#include "tracer/light/emitter_bounds.h"

#include <algorithm>
#include <cmath>

namespace orbs::tracer {

namespace {

Vec3f absolute(Vec3f v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }

Vec3f root_of_squares(Vec3f a, Vec3f b, Vec3f c = {}) {
  const Vec3f sum = a * a + b * b + c * c;
  return {std::sqrt(sum.x), std::sqrt(sum.y), std::sqrt(sum.z)};
}

LightBounds flat_bounds(Vec3f centre, Vec3f half, Vec3f normal, float power) {
  return {.low = centre - half,
          .high = centre + half,
          .radius = length(half),
          .axis = normal,
          .cos_spread = 1,
          .power = power};
}

LightBounds bounds_of(const RectEmitter& rect, float power) {
  return flat_bounds(rect.centre, absolute(rect.a) + absolute(rect.b), rect.normal, power);
}

LightBounds bounds_of(const DiskEmitter& disk, float power) {
  return flat_bounds(disk.centre, root_of_squares(disk.a, disk.b), disk.normal, power);
}

// A sphere shows a quarter of its area to each side.
LightBounds bounds_of(const SphereEmitter& sphere, float power) {
  const Vec3f half = root_of_squares(sphere.axes[0], sphere.axes[1], sphere.axes[2]);
  return {.low = sphere.centre - half,
          .high = sphere.centre + half,
          .radius = length(half),
          .axis = {0, 0, 1},
          .power = power / 4};
}

LightBounds bounds_of(const TriangleEmitter& t, float power) {
  const Vec3f b = t.corner + t.edge1;
  const Vec3f c = t.corner + t.edge2;
  const auto least = [](float x, float y, float z) { return std::min({x, y, z}); };
  const auto most = [](float x, float y, float z) { return std::max({x, y, z}); };
  LightBounds out{
      .low = {least(t.corner.x, b.x, c.x), least(t.corner.y, b.y, c.y), least(t.corner.z, b.z, c.z)},
      .high = {most(t.corner.x, b.x, c.x), most(t.corner.y, b.y, c.y), most(t.corner.z, b.z, c.z)},
      .axis = t.normal,
      .cos_spread = 1,
      .is_two_sided = true,
      .power = power};
  for (const Vec3f corner : {t.corner, b, c})
    out.radius = std::max(out.radius, length(corner - centre_of(out)));
  return out;
}

}  // namespace

std::vector<LightBounds> bounds_of(const std::vector<AreaLight>& lights,
                                   const std::vector<TriangleEmitter>& triangles,
                                   const std::vector<float>& powers) {
  std::vector<LightBounds> out;
  for (const AreaLight& light : lights) {
    const float power = powers[out.size()];
    out.push_back(std::visit([&](const auto& shape) { return bounds_of(shape, power); }, light.shape));
    if (light.ies) out.back().cos_spread = -1;  // a profile may send its light to any side
  }
  for (const TriangleEmitter& triangle : triangles) out.push_back(bounds_of(triangle, powers[out.size()]));
  return out;
}

}  // namespace orbs::tracer
