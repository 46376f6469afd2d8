#include "scene/geometry/extent.h"

#include "scene/geometry/world_bounds.h"

#include <algorithm>
#include <cmath>

namespace orbs::scene {

namespace {

// The least distance of the camera from a point while it moves.
double least_distance(const Camera& camera, Vec3d point) {
  const Vec3d way = camera.end ? camera.end->position_m - camera.position_m : Vec3d{};
  const double square = dot(way, way);
  const double time = square > 0 ? std::clamp(dot(point - camera.position_m, way) / square, 0.0, 1.0) : 0.0;
  return length(camera.position_m + way * time - point);
}

}  // namespace

Extent extent_of(const Scene& scene) {
  constexpr double kDistant = 16;  // radii: floats lose four bits by the distance
  const Camera& camera = scene.camera;
  const Vec3d eye = camera.position_m;
  const auto drawn = rough_bounds(scene);
  if (!drawn) return {eye};
  const double radius = radius_of(*drawn);
  const Vec3d centre = (drawn->low + drawn->high) * 0.5;
  if (radius > 0 && least_distance(camera, centre) > kDistant * radius) return {centre, radius, true};
  const auto with_eye = joined(*drawn, {eye, eye});
  if (!camera.end) return {eye, radius_of(with_eye)};
  return {eye, radius_of(joined(with_eye, {camera.end->position_m, camera.end->position_m}))};
}

Vec3d origin_near(const Extent& extent) {
  constexpr double kMostStep_m = 256;
  const double step = extent.radius_m > 0
                          ? std::min(kMostStep_m, std::exp2(std::ceil(std::log2(4 * extent.radius_m))))
                          : kMostStep_m;
  const auto nearest = [&](double m) { return step * std::round(m / step); };
  return {nearest(extent.centre.x), nearest(extent.centre.y), nearest(extent.centre.z)};
}

}  // namespace orbs::scene
