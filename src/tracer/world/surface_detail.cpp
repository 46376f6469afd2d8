#include "tracer/world/surface_detail.h"

#include "base/nth.h"
#include "tracer/geometry/tangent_frame.h"
#include "tracer/world/world.h"

#include <optional>

namespace orbs::tracer {

namespace {

struct Place {
  UvDirections directions;  // in world space, for the coordinates that the map is looked up at
  Vec2f uv;
};

// The coordinates are those after the map's matrix.
std::optional<Place> place_of(const World& world, const Hit& hit, const UvMap& map) {
  const RenderObject& object = world.objects[hit.object];
  const TriangleMesh& mesh = world.meshes[object.mesh];
  const auto& corners = mesh.triangles[hit.primitive];
  const TriangleCache& triangle = mesh.triangle_cache[hit.primitive];
  const bool is_instance = object.kind == ObjectKind::InstancedMesh;
  const Vec3f e1 = is_instance ? apply_to_direction(object.to_world, triangle.edge1) : triangle.edge1;
  const Vec3f e2 = is_instance ? apply_to_direction(object.to_world, triangle.edge2) : triangle.edge2;
  const Vec2f t0 = apply(map, mesh.uvs[corners[0]]);
  const Vec2f t1 = apply(map, mesh.uvs[corners[1]]);
  const Vec2f t2 = apply(map, mesh.uvs[corners[2]]);
  const Vec2f d1{t1.x - t0.x, t1.y - t0.y};
  const Vec2f d2{t2.x - t0.x, t2.y - t0.y};
  const auto directions = uv_directions(e1, e2, d1, d2);
  if (!directions) return std::nullopt;
  const auto [b1, b2] = hit.barycentric;
  return Place{*directions, {t0.x + b1 * d1.x + b2 * d2.x, t0.y + b1 * d1.y + b2 * d2.y}};
}

std::optional<Vec3f> mapped_normal(const World& world, const NormalTexture& map, const Hit& hit, Vec3f n) {
  const auto place = place_of(world, hit, map.uv);
  if (!place) return std::nullopt;
  const auto frame = tangent_frame(n, place->directions);
  if (!frame) return std::nullopt;
  const Vec3f texel = lookup(nth(world.textures, map.texture), place->uv) * 2 - Vec3f{1, 1, 1};
  return frame->along_u * (map.strength.x * texel.x) + frame->along_v * (map.strength.y * texel.y) +
         n * texel.z;
}

// n less the gradient of the height along the surface, times the area that one of u times one of v covers:
// (p_u + h_u n) x (p_v + h_v n), where p_u and p_v are those across the shading normal.
std::optional<Vec3f> bumped_normal(const World& world, const BumpTexture& map, const Hit& hit, Vec3f n) {
  const auto place = place_of(world, hit, map.uv);
  if (!place) return std::nullopt;
  const Vec2f slope = slope_of_red(nth(world.textures, map.texture), place->uv);
  const auto& [per_u, per_v] = place->directions;
  const Vec3f across_u = per_u - n * dot(n, per_u);
  const Vec3f across_v = per_v - n * dot(n, per_v);
  const Vec3f bumped =
      cross(across_u + n * (map.height_m * slope.x), across_v + n * (map.height_m * slope.y));
  return dot(bumped, n) < 0 ? -bumped : bumped;
}

}  // namespace

void turn_normal(const World& world, const Hit& hit, SurfacePoint& point) {
  const ObjectKind kind = world.objects[hit.object].kind;
  if (kind != ObjectKind::WorldMesh && kind != ObjectKind::InstancedMesh) return;
  const NormalDetail& detail = nth(world.normal_details, point.material);
  std::optional<Vec3f> turned;
  if (detail.normal.texture >= 0) turned = mapped_normal(world, detail.normal, hit, point.shading_normal);
  if (detail.bump.texture >= 0) turned = bumped_normal(world, detail.bump, hit, point.shading_normal);
  if (turned) point.shading_normal = unit_or(*turned, point.shading_normal);
}

}  // namespace orbs::tracer
