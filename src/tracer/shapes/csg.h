#pragma once

#include "tracer/shapes/solid.h"

#include <cstddef>

namespace orbs::tracer {

/// A ray in world space.
struct SolidRay {
  Vec3d origin;
  Vec3d direction;
};

/// The nearest boundary of a shape beyond `after`, strictly; a Miss has t = infinity.
BoundaryHit next_boundary(const Solid& solid, const SolidRay& ray, double after);

/// Where the search goes on behind a boundary of a solid by CSG. Faces that coincide give the same t up to
/// the rounding of their local rays, 2^-47 of the distance at most; all of them are passed together, as a
/// search from between them would take the last digits for a gap.
double past(const SolidRay& ray, double t);

/// What CSG makes of the nearest boundaries of its operands.
enum class Verdict { TakeA, TakeB, AdvanceA, AdvanceB, Miss };

/// The next step of `operation` where A's next boundary is `a` and B's is `b`; t within `tie` of each other
/// are equal.
Verdict next_step(scene::SetOperation operation, const BoundaryHit& a, const BoundaryHit& b, double tie);

}  // namespace orbs::tracer
