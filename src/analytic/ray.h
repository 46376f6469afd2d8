#pragma once

#include "base/vec.h"

namespace orbs::analytic {

/// A camera ray; the direction is unit.
struct Ray {
  Vec3d origin;
  Vec3d direction;
};

}  // namespace orbs::analytic
