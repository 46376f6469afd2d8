#pragma once

#include "analytic/ray.h"
#include "registry/analytic.h"

#include <array>

namespace orbs::analytic {

/// Reflectance of unpolarised light at the cosine of the angle to the normal, by the relative index n + i k
/// (Born and Wolf, 1.5.2 and 14.2); 1 where everything is reflected.
double fresnel_reflectance(double cosine, double n, double k);

/// What the image shows along the ray: the radiance times R, or times (1 - R) / (1 + (2 plates - 1) R), the
/// sum over all reflections between the 2 plates surfaces of an incoherent stack (Stokes 1862). Both hold
/// for a renderer without polarisation.
std::array<double, 3> fresnel_plane(const registry::FresnelPlane& image, const Ray& ray);

}  // namespace orbs::analytic
