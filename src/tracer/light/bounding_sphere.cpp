#include "tracer/light/bounding_sphere.h"

#include "base/in_double.h"
#include "tracer/geometry/transforms.h"
#include "tracer/sampling/warps.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace orbs::tracer {

namespace {

// 1 - cos of the half angle that the sphere subtends; nothing from inside.
std::optional<float> cone_height(const BoundingSphere& sphere, Vec3f from) {
  const Vec3f d = sphere.centre - from;
  const float sin2 = sphere.radius * sphere.radius / dot(d, d);
  if (!(sin2 < 1)) return std::nullopt;
  return sin2 / (1 + std::sqrt(1 - sin2));
}

Vec3f sample_cone(Vec3f axis, float height, float u, float v) {
  const float down = u * height;
  const float sine = std::sqrt(down * (2 - down));
  const float phi = 2 * kPi * v;
  return frame_around(axis).to_world({sine * in_double::cos(phi), sine * in_double::sin(phi), 1 - down});
}

// Of a sphere seen from outside.
float cone_pdf(const BoundingSphere& sphere, float height, Vec3f from, Vec3f direction, bool was_chosen) {
  const Vec3f off_axis = direction - normalised(sphere.centre - from);
  const float down = dot(off_axis, off_axis) / 2;  // 1 - cos, without its cancellation
  return was_chosen || down <= height ? 1 / (2 * kPi * height) : 0;
}

constexpr float kWholeSphere = 2;  // 1 - cos of its half angle

}  // namespace

Vec3f direction_towards(const BoundingSphere& sphere, Vec3f from, Vec3f normal, float u, float v) {
  const auto height = cone_height(sphere, from);
  return height ? sample_cone(normalised(sphere.centre - from), *height, u, v)
                : frame_around(normal).to_world(sample_cosine(u, v));
}

float pdf_towards(const BoundingSphere& sphere, Vec3f from, Vec3f normal, Vec3f direction, bool was_chosen) {
  const auto height = cone_height(sphere, from);
  if (!height) return std::max(0.0F, dot(normal, direction)) * kInvPi;
  return cone_pdf(sphere, *height, from, direction, was_chosen);
}

Vec3f direction_towards(const BoundingSphere& sphere, Vec3f from, float u, float v) {
  const auto height = cone_height(sphere, from);
  return height ? sample_cone(normalised(sphere.centre - from), *height, u, v)
                : sample_cone({0, 0, 1}, kWholeSphere, u, v);
}

float pdf_towards(const BoundingSphere& sphere, Vec3f from, Vec3f direction, bool was_chosen) {
  const auto height = cone_height(sphere, from);
  return height ? cone_pdf(sphere, *height, from, direction, was_chosen) : 1 / (2 * kPi * kWholeSphere);
}

}  // namespace orbs::tracer
