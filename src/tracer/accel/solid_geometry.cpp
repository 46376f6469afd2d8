#include "tracer/accel/solid_geometry.h"

#include "tracer/shapes/solid_hit.h"

namespace orbs::tracer {

UserBounds bounds_of(const Solid& solid) { return {solid.low, solid.high}; }

std::optional<Hit> hit_of(const Solid& solid, unsigned int, const UserRay& ray) {
  return intersect(solid, ray.origin, ray.direction, ray.near, ray.far);
}

}  // namespace orbs::tracer
