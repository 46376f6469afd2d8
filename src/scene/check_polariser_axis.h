#pragma once

#include "scene/scene.h"

#include <string>

namespace orbs::scene {

/// Thin optical elements (polarisers, retarders) project their axis into the surface that shows them. The
/// complaint where that is impossible: the axis is perpendicular to a triangle, or the surface is a sphere.
/// "" for a material without an axis, and where all is well.
std::string check_polariser_axis(const Scene& scene, int material);

}  // namespace orbs::scene
