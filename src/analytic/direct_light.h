#pragma once

#include "analytic/ray.h"
#include "registry/analytic.h"

namespace orbs::analytic {

/// The radiance that arrives along the ray, by the form factors of all sources: the nearest surface's own, or
/// rho (L_e + sum F (L - L_e)) where it is lit, with the radiance L_e of the environment, which each source
/// hides. InputError as coverage.
double direct_light(const registry::DirectLight& image, const Ray& ray);

}  // namespace orbs::analytic
