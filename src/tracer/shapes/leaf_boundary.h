#pragma once

#include "tracer/shapes/solid.h"

namespace orbs::tracer {

/// The nearest boundary of a leaf beyond `after`, strictly. Its t does not depend on `after`, so that a
/// caller who passes it gets the next one. A half-space that the ray never leaves is left at infinity.
/// BoundaryHit::leaf stays 0.
BoundaryHit next_boundary(const QuadricLeaf& leaf, const LocalRay& ray, double after);
BoundaryHit next_boundary(const DiskLeaf& leaf, const LocalRay& ray, double after);
BoundaryHit next_boundary(const BoxLeaf& leaf, const LocalRay& ray, double after);
BoundaryHit next_boundary(const HalfSpaceLeaf& leaf, const LocalRay& ray, double after);

}  // namespace orbs::tracer
