#pragma once

#include "tracer/accel/user_geometry.h"
#include "tracer/shapes/solid.h"

namespace orbs::tracer {

/// For make_user_geometry; hits have what intersect() in solid_hit.h says.
UserBounds bounds_of(const Solid& solid);
std::optional<Hit> hit_of(const Solid& solid, unsigned int index, const UserRay& ray);

}  // namespace orbs::tracer
