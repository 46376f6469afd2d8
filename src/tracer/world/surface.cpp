#include "tracer/world/surface.h"

#include "base/in_double.h"
#include "base/nth.h"
#include "tracer/colour/uv_at.h"
#include "tracer/numeric_fault.h"
#include "tracer/plugins/plugin_hit.h"
#include "tracer/sampling/warps.h"
#include "tracer/shapes/solid_hit.h"
#include "tracer/world/moving_surface.h"
#include "tracer/world/surface_detail.h"
#include "tracer/world/uv_directions.h"

#include <algorithm>

namespace orbs::tracer {

namespace {

// Of the unit normals that `of_vertex` makes of those of the mesh. A matrix that stretches comes first: a
// mesh looks the same then, whether it is an instance or was copied to its place.
template <typename OfVertex>
Vec3f interpolated_normal(const TriangleMesh& mesh, const Hit& hit, OfVertex of_vertex) {
  const auto& corners = mesh.triangles[hit.primitive];
  const float b1 = hit.barycentric.x;
  const float b2 = hit.barycentric.y;
  return of_vertex(mesh.normals[corners[0]]) * (1 - b1 - b2) + of_vertex(mesh.normals[corners[1]]) * b1 +
         of_vertex(mesh.normals[corners[2]]) * b2;
}

Vec3f shading_normal_from(Vec3f interpolated, Vec3f geometric_normal) {
  if (has_fault(NumericFault::UnnormalisedNormals)) return interpolated;
  return unit_or(interpolated, geometric_normal);
}

// Rounding error perpendicular to the plane, in half ulp of the size of the corners: about 6 for the sum of
// corner and edges, and 6 for the differences corner - origin in the intersection test of the next ray.
// (Error analysis as in Physically Based Rendering, 4th ed., 6.8.5; errors within the plane do no harm but
// beside an edge, see nearest_hits.h.)
constexpr float kTriangleRounding = 12 * 0x1p-24F;
// The transform of an instance adds 4 for the corner and for the end of each edge.
constexpr float kInstanceRounding = 20 * 0x1p-24F;

WorldTriangle of_instance(const RenderObject& object, const TriangleCache& triangle) {
  const Vec3f corner = apply_to_point(object.to_world, triangle.corner);
  const Vec3f edge1 = apply_to_direction(object.to_world, triangle.edge1);
  const Vec3f edge2 = apply_to_direction(object.to_world, triangle.edge2);
  const float size = std::max(
      {largest_magnitude(corner), largest_magnitude(corner + edge1), largest_magnitude(corner + edge2)});
  return {corner, edge1, edge2, kInstanceRounding * size};
}

SurfacePoint point_on_instance(const World& world, const RenderObject& object, const Hit& hit) {
  const TriangleMesh& mesh = world.meshes[object.mesh];
  const TriangleCache& triangle = mesh.triangle_cache[hit.primitive];
  const auto in_place = of_instance(object, triangle);
  SurfacePoint out;
  out.material = nth(object.material_of, triangle.material);
  out.position = point_on(in_place, hit.barycentric);
  out.geometric_normal = normalised(cross(in_place.edge1, in_place.edge2));
  const auto in_world = [&](Vec3f normal) { return apply_to_direction(object.normal_to_world, normal); };
  out.shading_normal = shading_normal_from(
      triangle.has_one_normal
          ? in_world(triangle.shading_normal)
          : interpolated_normal(mesh, hit, [&](Vec3f normal) { return normalised(in_world(normal)); }),
      out.geometric_normal);
  out.position_error = in_place.position_error;
  return out;
}

// The hit point is known in double. What remains is the rounding of the point and of the origin beside it.
constexpr float kSolidRounding = 4 * 0x1p-24F;

// A place on a triangle that is much larger than the scene on it: interpolated from the corners it would be
// off by their rounding. By the ray it is as accurate as its distance, and in the plane of the corners in
// double.
void place_in_plane(const TriangleMesh& mesh, const Ray& ray, const Hit& hit, SurfacePoint& out) {
  const auto& corners = mesh.triangles[hit.primitive];
  const auto corner = [&](std::size_t i) { return mesh.exact_positions[corners[i]]; };
  const Vec3d normal = normalised(cross(corner(1) - corner(0), corner(2) - corner(0)));
  const Vec3d by_ray =
      cast<double>(ray.origin) + cast<double>(ray.direction) * static_cast<double>(hit.distance);
  out.position = cast<float>(by_ray + normal * dot(normal, corner(0) - by_ray));
  out.geometric_normal = cast<float>(normal);
  const double size =
      std::max({largest_magnitude(corner(0)), largest_magnitude(corner(1)), largest_magnitude(corner(2))});
  out.position_error =
      kSolidRounding * largest_magnitude(out.position) + static_cast<float>(kDoubleRounding * size);
}

SurfacePoint point_on_shape(const SolidPoint& point) {
  SurfacePoint out;
  out.material = point.material;
  out.position = cast<float>(point.position);
  out.geometric_normal = cast<float>(point.normal);
  out.shading_normal = out.geometric_normal;
  out.position_error = kSolidRounding * largest_magnitude(out.position) + static_cast<float>(point.error);
  return out;
}

SurfacePoint point_on_sphere(const SphereSurface& sphere, const Ray& ray, const Hit& hit) {
  const double t = static_cast<double>(hit.distance) + static_cast<double>(hit.barycentric.x);
  SolidPoint out;
  out.material = sphere.material;
  out.normal = normalised(cast<double>(ray.origin) + cast<double>(ray.direction) * t - sphere.centre);
  out.position = sphere.centre + out.normal * sphere.radius;
  out.error = kDoubleRounding * (largest_magnitude(sphere.centre) + sphere.radius);
  return point_on_shape(out);
}

// Surfaces other than meshes in world space.
SurfacePoint other_point(const World& world, const RenderObject& object, const Ray& ray, const Hit& hit) {
  if (object.kind == ObjectKind::Sphere) return point_on_sphere(world.spheres[object.sphere], ray, hit);
  if (object.kind == ObjectKind::Solid)
    return point_on_shape(point_on_solid(world.solids[object.solid], ray, hit));
  if (object.kind == ObjectKind::PluginShape)
    return point_on_shape(point_on_plugin(world.plugin_shapes[object.plugin_shape], ray, hit));
  if (object.kind == ObjectKind::MovingMesh)
    return point_on_moving_mesh(object, world.meshes[object.mesh], ray, hit);
  return point_on_instance(world, object, hit);
}

Vec2f uv_of_sphere(Vec3f n) {
  const float around = in_double::atan2(n.x, n.z) / (2 * kPi);
  // Rounding only: n is a unit vector.
  return {around < 0 ? around + 1 : around, 0.5F + in_double::asin(std::clamp(n.y, -1.0F, 1.0F)) * kInvPi};
}

}  // namespace

void fill_triangle_cache(TriangleMesh& mesh) {
  mesh.triangle_cache.resize(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& corners = mesh.triangles[i];
    const Vec3f p0 = mesh.positions[corners[0]];
    const Vec3f p1 = mesh.positions[corners[1]];
    const Vec3f p2 = mesh.positions[corners[2]];
    const Vec3f n0 = mesh.normals[corners[0]];
    TriangleCache& triangle = mesh.triangle_cache[i];
    triangle.corner = p0;
    triangle.edge1 = p1 - p0;
    triangle.edge2 = p2 - p0;
    triangle.material = mesh.materials[i];
    triangle.geometric_normal = unit_or(cross(triangle.edge1, triangle.edge2), {});
    triangle.has_one_normal = n0 == mesh.normals[corners[1]] && n0 == mesh.normals[corners[2]];
    triangle.shading_normal = unit_or(n0, triangle.geometric_normal);
    triangle.size = std::max({largest_magnitude(p0), largest_magnitude(p1), largest_magnitude(p2)});
  }
}

SurfacePoint light_point(const AreaLight& light, const Ray& ray, const Hit& hit) {
  SurfacePoint out;
  out.position = ray.origin + ray.direction * hit.distance;
  out.geometric_normal = normal_of(light.shape, out.position);
  out.shading_normal = out.geometric_normal;
  // The hit distance and the origin of the ray are rounded as well.
  out.position_error =
      rounding_of(light.shape) + 4 * 0x1p-24F * (largest_magnitude(ray.origin) + hit.distance);
  return out;
}

namespace {

SurfacePoint surface_point_as_is(const World& world, const Ray& ray, const Hit& hit) {
  const RenderObject& object = world.objects[hit.object];
  if (object.kind != ObjectKind::WorldMesh) return other_point(world, object, ray, hit);
  const TriangleMesh& mesh = world.meshes[object.mesh];
  const TriangleCache& triangle = mesh.triangle_cache[hit.primitive];
  SurfacePoint out;
  out.material = nth(object.material_of, triangle.material);
  out.position = triangle.corner + triangle.edge1 * hit.barycentric.x + triangle.edge2 * hit.barycentric.y;
  out.geometric_normal = triangle.geometric_normal;
  out.shading_normal =
      triangle.has_one_normal
          ? triangle.shading_normal
          : shading_normal_from(interpolated_normal(mesh, hit, [](Vec3f normal) { return normal; }),
                                triangle.geometric_normal);
  out.position_error = kTriangleRounding * triangle.size;
  if (!mesh.exact_positions.empty()) place_in_plane(mesh, ray, hit, out);
  return out;
}

float faulty_position_error(const SurfacePoint& point) {
  constexpr float kMillimetre = 1e-3F;
  constexpr float kOfCoordinates = 1e-5F;
  if (has_fault(NumericFault::NoRayOffset)) return 0;
  if (has_fault(NumericFault::RayOffsetInMetres)) return kMillimetre;
  // The bound of the rounding is 12 to 20 half ulps of the largest coordinate.
  if (has_fault(NumericFault::RayOffsetByCoordinates))
    return point.position_error / kTriangleRounding * kOfCoordinates;
  return point.position_error;
}

}  // namespace

std::optional<WorldTriangle> triangle_in_world(const World& world, const Hit& hit) {
  const RenderObject& object = world.objects[hit.object];
  if (object.kind != ObjectKind::WorldMesh && object.kind != ObjectKind::InstancedMesh) return std::nullopt;
  const TriangleMesh& mesh = world.meshes[object.mesh];
  const TriangleCache& triangle = mesh.triangle_cache[hit.primitive];
  if (object.kind == ObjectKind::InstancedMesh) return of_instance(object, triangle);
  if (!mesh.exact_positions.empty()) return std::nullopt;
  return WorldTriangle{triangle.corner, triangle.edge1, triangle.edge2, kTriangleRounding * triangle.size};
}

SurfacePoint surface_point(const World& world, const Ray& ray, const Hit& hit) {
  auto point = surface_point_as_is(world, ray, hit);
  if (!world.normal_details.empty()) turn_normal(world, hit, point);
  point.position_error = faulty_position_error(point);
  return point;
}

namespace {

// Of shapes by their formula.
Vec2f coordinates_on_shape(const World& world, const SurfaceHit& surface) {
  const Hit& hit = surface.hit;
  const RenderObject& object = world.objects[hit.object];
  if (object.kind == ObjectKind::PluginShape) return hit.barycentric;
  return object.kind == ObjectKind::Sphere
             ? uv_of_sphere(surface.point.geometric_normal)
             : texture_coordinates(world.solids[object.solid], hit, surface.point.position);
}

}  // namespace

Vec2f texture_coordinates(const World& world, const SurfaceHit& surface, const UvMap& map) {
  const Hit& hit = surface.hit;
  const RenderObject& object = world.objects[hit.object];
  if (object.kind == ObjectKind::PluginShape || is_analytic(object.kind))
    return apply(map, coordinates_on_shape(world, surface));
  return uv_at(world.meshes[object.mesh], hit, map);
}

Vec3f direction_of_u(const World& world, const SurfaceHit& surface) {
  const RenderObject& object = world.objects[surface.hit.object];
  if (object.kind == ObjectKind::Sphere) {
    const Vec3f n = surface.point.geometric_normal;
    return {n.z, 0, -n.x};  // u turns about y, from z to x
  }
  const auto directions = uv_directions_at(world, surface.hit, UvMap{});
  return directions ? directions->along_u : Vec3f{};
}

Radiance emitted_radiance(const World& world, const EmissionMaterial& material, Vec2f uv) {
  const auto& [colour, texture, uv_map] = material.radiance;
  if (texture < 0) return {colour.rgb, colour.spectrum};
  return {colour.rgb * lookup(nth(world.textures, texture), uv)};
}

}  // namespace orbs::tracer
