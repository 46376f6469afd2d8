#pragma once

#include "tracer/shapes/solid.h"

namespace orbs::tracer {

/// Which roots count: all of an open surface, also those where f touches zero; or those alone that change the
/// sign of f, which enter or leave a solid.
enum class Roots { All, SignChanges };

/// The nearest boundary of an implicit surface beyond `after`, as next_boundary in leaf_boundary.h. No root
/// is passed over: a part of the ray is left out only where interval arithmetic proves that f is not zero
/// there, or that it is monotone and keeps its sign (Mitchell 1990, Robust Ray Intersection with Interval
/// Arithmetic; Moore, Kearfott, Cloud 2009, ch. 8, with the mean value form). Near parts are searched first.
BoundaryHit next_boundary(
    const ImplicitLeaf& leaf, const LocalRay& ray, double after, Roots roots, RootCounts& counts);

/// The unit normal of f at a point of the surface, towards larger f. At singular points, where the gradient
/// is zero, that beside it; nothing where there is none either.
std::optional<Vec3d> implicit_normal(const scene::Expression& expression, Vec3d point);

}  // namespace orbs::tracer
