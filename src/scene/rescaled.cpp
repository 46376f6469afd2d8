#include "scene/rescaled.h"

#include "scene/world_bounds.h"

#include <cmath>

namespace orbs::scene {

double enlargement_to(const Scene& scene, double least_radius_m) {
  const auto drawn = rough_bounds(scene);
  if (!drawn) return 1;
  const Vec3d eye = scene.camera.position_m;
  const double radius = radius_of(joined(*drawn, {eye, eye}));
  if (!(radius > 0) || radius >= least_radius_m) return 1;
  return std::exp2(std::ceil(std::log2(least_radius_m / radius)));
}

}  // namespace orbs::scene
