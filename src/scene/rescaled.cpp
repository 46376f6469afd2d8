#include "scene/rescaled.h"

#include "scene/world_bounds.h"

#include <cmath>

namespace orbs::scene {

namespace {

// Of the box around all that is drawn and the camera; 0 where nothing is drawn.
double radius_with_camera(const Scene& scene) {
  const auto drawn = rough_bounds(scene);
  if (!drawn) return 0;
  const Vec3d eye = scene.camera.position_m;
  return radius_of(joined(*drawn, {eye, eye}));
}

}  // namespace

double enlargement_to(const Scene& scene, double least_radius_m) {
  const double radius = radius_with_camera(scene);
  if (!(radius > 0) || radius >= least_radius_m) return 1;
  return std::exp2(std::ceil(std::log2(least_radius_m / radius)));
}

double reduction_to(const Scene& scene, double most_radius_m) {
  const double radius = radius_with_camera(scene);
  if (radius <= most_radius_m) return 1;
  return std::exp2(std::floor(std::log2(most_radius_m / radius)));
}

}  // namespace orbs::scene
