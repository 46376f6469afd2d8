#pragma once

#include "analytic/ray.h"
#include "registry/analytic.h"

#include <array>

namespace orbs::analytic {

/// S0 to S3 of the light along the ray, in the frame and with the signs of the scene format: horizontal is
/// `right`, projected across the ray, for an observer who looks at the oncoming light.
std::array<double, 4> polarised_planes(const registry::PolarisedPlanes& image, const Ray& ray, Vec3d right);

}  // namespace orbs::analytic
