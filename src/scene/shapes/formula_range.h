#pragma once

#include "base/vec.h"
#include "scene/shapes/expression.h"

/// Whether a formula has values in a box at all.
namespace orbs::scene {

/// False where f is neither finite at one of 4096 places of the box nor bounded by intervals in one of 512
/// parts of it, as x / 0 and x / (y - y): no ray finds a root, and none can show that there is none.
bool has_values(const Expression& expression, Vec3d low, Vec3d high);

}  // namespace orbs::scene
