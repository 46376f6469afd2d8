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

/// A hit point on a shape, in world space.
struct SolidPoint {
  Vec3d position;
  Vec3d normal;  // unit, out of the shape
  int material = 0;
};

SolidPoint point_on_solid(const Solid& solid, const Ray& ray, const Hit& hit);

/// Defined in docs/reference/scene-format.md.
Vec2f texture_coordinates(const Solid& solid, const Hit& hit, Vec3f position);

}  // namespace orbs::tracer
