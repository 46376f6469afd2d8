#include "scene/geometry/extent.h"

#include "scene/geometry/world_bounds.h"

#include <algorithm>
#include <cmath>

namespace orbs::scene {

Extent extent_of(const Scene& scene) {
  constexpr double kDistant = 16;  // radii: floats lose four bits by the distance
  const Vec3d eye = scene.camera.position_m;
  const auto drawn = rough_bounds(scene);
  if (!drawn) return {eye};
  const double radius = radius_of(*drawn);
  const Vec3d centre = (drawn->low + drawn->high) * 0.5;
  if (radius > 0 && length(eye - centre) > kDistant * radius) return {centre, radius, true};
  return {eye, radius_of(joined(*drawn, {eye, eye}))};
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
