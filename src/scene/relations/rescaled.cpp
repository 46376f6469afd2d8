#include "scene/relations/rescaled.h"

#include "scene/geometry/world_bounds.h"

#include <cassert>
#include <cmath>

namespace orbs::scene {

double rescaling_into(const Scene& scene, double least_radius_m, double most_radius_m) {
  assert(most_radius_m >= 2 * least_radius_m && "else no power of two may lead there");
  const auto drawn = rough_bounds(scene);
  if (!drawn) return 1;
  const Vec3d eye = scene.camera.position_m;
  const double radius = radius_of(joined(*drawn, {eye, eye}));
  if (!(radius > 0)) return 1;
  if (radius < least_radius_m) return std::exp2(std::ceil(std::log2(least_radius_m / radius)));
  if (radius > most_radius_m) return std::exp2(std::floor(std::log2(most_radius_m / radius)));
  return 1;
}

}  // namespace orbs::scene
