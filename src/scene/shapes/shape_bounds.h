#pragma once

#include "scene/shapes/shape.h"

#include <vector>

namespace orbs::scene {

/// The corners of boxes that together hold the shape, in the world. Of solids by CSG those of all operands
/// that have an end: what is taken away as well.
std::vector<Vec3d> bounding_corners(const Shape& shape);

}  // namespace orbs::scene
