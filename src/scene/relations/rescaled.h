#pragma once

#include "scene/scene.h"

namespace orbs::scene {

/// The power of two by which all lengths are multiplied so that the radius of what is drawn, with the camera,
/// is at least `least_radius_m` and at most `most_radius_m`, which must be twice as large or more; 1 where it
/// is. Floats are multiplied by it without rounding.
double rescaling_into(const Scene& scene, double least_radius_m, double most_radius_m);

}  // namespace orbs::scene
