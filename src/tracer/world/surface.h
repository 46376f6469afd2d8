#pragma once

#include "tracer/geometry/lanes.h"
#include "tracer/world/world.h"

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
void fill_triangle_cache(TriangleMesh& mesh);

/// Where the ray has met a mesh or a sphere.
SurfacePoint surface_point(const World& world, const Ray& ray, const Hit& hit);

/// Where it has met a light, whose bright side it must see. There is no material.
SurfacePoint light_point(const AreaLight& light, const Ray& ray, const Hit& hit);

/// What a ray has met.
struct SurfaceHit {
  const SurfacePoint& point;
  const SurfaceMaterial& material;
  const Hit& hit;
};

/// Texture coordinates as the mesh gives them; of a sphere as scene::Sphere says.
Vec2f texture_coordinates(const World& world, const SurfaceHit& surface);

/// Radiance that an emissive material sends out at these coordinates.
Radiance emitted_radiance(const World& world, const SurfaceMaterial& material, Vec2f uv);

/// `position` moved off the surface to the side of `direction`, beyond the error of the position.
template <typename V, typename Real>
V offset_origin(V position, Real position_error, V geometric_normal, V direction) {
  // The bound holds for each coordinate; along the normal it adds up to the normal's 1-norm.
  const V n = geometric_normal;
  const Real offset = position_error * (magnitude(n.x) + magnitude(n.y) + magnitude(n.z));
  return position + n * with_sign_of(offset, dot(n, direction));
}

/// True where a direction lies on the same side of the real surface as of the shading normal: the others
/// would pass through an opaque surface, or count as reflection what goes through. For eight paths a mask.
template <typename V>
auto sides_agree(V geometric_normal, V shading_normal, V direction) {
  using Real = decltype(direction.x);
  const Real same_side = with_sign_of(Real{} + 1.0F, dot(geometric_normal, shading_normal));
  return dot(geometric_normal, direction) * same_side * dot(shading_normal, direction) > 0.0F;
}

}  // namespace orbs::tracer
