#pragma once

#include "scene/scene.h"

namespace orbs::scene {

/// The power of two by which all lengths are multiplied so that the radius of what is drawn, with the camera,
/// is at least `least_radius_m`; 1 where it is. Floats are multiplied by it without rounding.
double enlargement_to(const Scene& scene, double least_radius_m);

/// Likewise so that the radius is at most `most_radius_m`; 1 where it is.
double reduction_to(const Scene& scene, double most_radius_m);

}  // namespace orbs::scene
