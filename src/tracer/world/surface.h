#pragma once

#include "base/nth.h"
#include "tracer/geometry/lanes.h"
#include "tracer/geometry/surface_point.h"
#include "tracer/numeric_fault.h"
#include "tracer/world/world.h"

#include <optional>

/// Hit points.
namespace orbs::tracer {

/// Fills mesh.triangle_cache.
void fill_triangle_cache(TriangleMesh& mesh);

/// A triangle of a mesh at rest, and the bound of SurfacePoint::position_error on it.
struct WorldTriangle {
  Vec3f corner;
  Vec3f edge1;
  Vec3f edge2;
  float position_error = 0;
};

inline Vec3f point_on(const WorldTriangle& triangle, Vec2f barycentric) {
  return triangle.corner + triangle.edge1 * barycentric.x + triangle.edge2 * barycentric.y;
}

/// The triangle that is hit. Empty for what moves, for shapes, and where surface_point() does not go by the
/// barycentric coordinates of the hit.
std::optional<WorldTriangle> triangle_in_world(const World& world, const Hit& hit);

/// The point where the ray hits a mesh or a shape.
SurfacePoint surface_point(const World& world, const Ray& ray, const Hit& hit);

/// The point where the ray hits a light, on its bright side. It has no material.
SurfacePoint light_point(const AreaLight& light, const Ray& ray, const Hit& hit);

/// A hit on a surface with a material.
struct SurfaceHit {
  const SurfacePoint& point;
  const SurfaceMaterial& material;
  const Hit& hit;
};

/// Where a texture is looked up: the coordinates given by the mesh, of which the map says the set, mapped.
/// Those of a sphere are defined at scene::Sphere.
Vec2f texture_coordinates(const World& world, const SurfaceHit& surface, const UvMap& map);

/// The direction in the world in which the texture coordinate u grows at the surface, of any length; zero
/// where the coordinates have none, and on surfaces that are neither meshes at rest nor spheres. Of the first
/// coordinates of a mesh.
Vec3f direction_of_u(const World& world, const SurfaceHit& surface);

/// Radiance that an emissive material emits at these texture coordinates, to which its UV matrix is applied
/// already.
Radiance emitted_radiance(const World& world, const EmissionMaterial& material, Vec2f uv);

/// Index of the triangle of the object in World::emitters, or -1.
inline int emitter_of(const World& world, std::uint32_t object, std::uint32_t triangle) {
  const auto& emitters = world.objects[object].emitters;
  return emitters.empty() ? -1 : emitters[triangle];
}

/// Material of a triangle in the table of emitters.
inline const EmissionMaterial& emission_of(const World& world, const TriangleEmitter& triangle) {
  return std::get<EmissionMaterial>(nth(world.materials, triangle.material).model);
}

/// The shape of a plug-in that is this emitter; nullptr if it is another.
inline const PluginShape* plugin_emitter(const World& world, std::size_t emitter) {
  const PluginEmitter* found = world.emitters.plugin_shape(emitter);
  return found == nullptr ? nullptr : &world.plugin_shapes[found->shape];
}

/// Radiance of a shape of a plug-in in the table of emitters.
inline Radiance radiance_of(const World& world, const PluginShape& shape) {
  return emitted_radiance(world, std::get<EmissionMaterial>(nth(world.materials, shape.material).model), {});
}

/// Index of the mirror plane that contains the triangle of the object, or -1.
inline int mirror_plane_of(const World& world, std::uint32_t object, std::uint32_t triangle) {
  const auto& planes = world.objects[object].mirror_planes;
  return planes.empty() ? -1 : planes[triangle];
}

/// Origin of a ray that leaves `position` in this direction: offset along the normal beyond the position
/// error.
template <typename V, typename Real>
V offset_origin(V position, Real position_error, V geometric_normal, V direction) {
  // The bound holds for each coordinate; its component along the normal is scaled by the 1-norm of the
  // normal.
  const V n = geometric_normal;
  const Real offset = position_error * (magnitude(n.x) + magnitude(n.y) + magnitude(n.z));
  return position + n * with_sign_of(offset, dot(n, direction));
}

/// True if a direction is on the same side of the geometric as of the shading normal. Other directions would
/// leak light through the surface (Veach 1997, 5.3.5). Returns a mask for eight paths.
template <typename V>
auto sides_agree(V geometric_normal, V shading_normal, V direction) {
  using Real = decltype(direction.x);
  if (has_fault(NumericFault::ShadingNormalDecidesSide)) return Real{} + 1.0F > 0.0F;
  const Real same_side = with_sign_of(Real{} + 1.0F, dot(geometric_normal, shading_normal));
  return dot(geometric_normal, direction) * same_side * dot(shading_normal, direction) > 0.0F;
}

}  // namespace orbs::tracer
