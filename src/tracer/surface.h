#pragma once

#include "tracer/world.h"

#include <cmath>

/// Where rays meet meshes.
namespace orbs::tracer {

/// A point on a surface. All vectors are in world space.
struct SurfacePoint {
  Vec3f position;
  float position_error =
      0;  // bound of the distance between `position` and the plane that Embree met, in metres
  Vec3f geometric_normal;  // unit, either side
  Vec3f shading_normal;    // interpolated as given, unit, not turned to the viewer
  int material = 0;
};

/// Works out `faces`.
void prepare_faces(TriangleMesh& mesh);

SurfacePoint surface_point(const World& world, const Hit& hit);

/// Texture coordinates at a hit, as the mesh gives them.
Vec2f texture_coordinates(const World& world, const Hit& hit);

/// Radiance that an emissive material sends out at these coordinates.
Vec3f emitted_radiance(const World& world, const SurfaceMaterial& material, Vec2f uv);

/// The point's position moved off the surface to the side of `direction`, beyond the error of the position.
inline Vec3f offset_origin(const SurfacePoint& point, Vec3f direction) {
  const Vec3f n = point.geometric_normal;
  // The bound holds for each coordinate; along n it adds up to the 1-norm of n.
  const float offset = point.position_error * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
  return point.position + n * std::copysign(offset, dot(n, direction));
}

}  // namespace orbs::tracer
