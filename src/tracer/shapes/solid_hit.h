#pragma once

#include "tracer/geometry/ray.h"
#include "tracer/shapes/csg.h"

#include <optional>

/// Shapes as Embree hits them.
namespace orbs::tracer {

/// The nearest boundary within the ray's reach as a hit: the distance in float and what float leaves of it in
/// barycentric.x, so that both together are the double; leaf, face and side in `primitive`. Nothing outside
/// (near, far).
std::optional<Hit> intersect(const Solid& solid, Vec3f origin, Vec3f direction, float near, float far);

/// Rounding of a place on a shape in double, over the shape's size with its distance from zero: the matrix to
/// the space of the shape and back, and the coefficients of a quadratic equation, whose error is divided by
/// twice the size, are each off by less than two halves of the last digit.
constexpr double kDoubleRounding = 0x1p-50;

/// A hit point on a shape, in world space.
struct SolidPoint {
  Vec3d position;
  Vec3d normal;  // unit, out of the shape
  int material = 0;
  double error = 0;  // bound of the distance between `position` and the surface that the next ray meets
};

SolidPoint point_on_solid(const Solid& solid, const Ray& ray, const Hit& hit);

/// Defined in docs/reference/scene-format.md.
Vec2f texture_coordinates(const Solid& solid, const Hit& hit, Vec3f position);

}  // namespace orbs::tracer
