#pragma once

#include "base/vec.h"

/// Rays leave a surface from a point beside it, offset along the normal. Within about that offset of an edge,
/// where another triangle rises at an acute angle, the point lies behind this other triangle. A point that
/// keeps a distance from the edges of its own does not.
namespace orbs::tracer {

/// In units of position_error. The offset is at most sqrt(3) of them. A point at the distance s from an edge,
/// offset by o, lies s sin(a) - o cos(a) before the plane of a triangle that meets the edge at the angle a.
/// With s = 16 that is more than one unit, which the rounding of that plane needs, down to an angle of 16
/// degrees.
constexpr float kEdgeDistance = 16;

/// The largest distance, as a share of the triangle's height above the edge. What is smaller than a thousand
/// position errors, or lies so far from the origin, is moved by less than anyone sees, and may leak as
/// before.
constexpr float kMostOfHeight = 0x1p-10F;

/// By what the barycentric coordinates of a point change that keeps its distance from the edges of a
/// triangle: zero for nearly all. `barycentric`: of the second and the third corner. `edge1`, `edge2`: from
/// the first corner to these, not parallel.
Vec2f away_from_edges(Vec2f barycentric, Vec3f edge1, Vec3f edge2, float position_error);

}  // namespace orbs::tracer
