#pragma once

#include "analytic/ray.h"
#include "registry/analytic.h"

#include <array>

namespace orbs::analytic {

/// What a ray sees of the plane: black where it does not meet it.
std::array<double, 3> textured_plane(const registry::TexturedPlane& plane, const Ray& ray);

}  // namespace orbs::analytic
