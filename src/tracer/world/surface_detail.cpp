#include "tracer/world/surface_detail.h"

#include "base/nth.h"
#include "tracer/colour/texture.h"
#include "tracer/world/uv_directions.h"
#include "tracer/world/world.h"

#include <optional>

namespace orbs::tracer {

namespace {

// As uv_at(mesh, hit, map), but mapped before it is interpolated: the other rounding would turn normals by
// the last digit, and with them what is taken for like pixels where variances are estimated.
Vec2f map_at(const World& world, const Hit& hit, const UvMap& map) {
  const TriangleMesh& mesh = world.meshes[world.objects[hit.object].mesh];
  const std::vector<Vec2f>& uvs = uvs_of(mesh, map.set);
  const auto& corners = mesh.triangles[hit.primitive];
  const Vec2f t0 = apply(map, uvs[corners[0]]);
  const Vec2f t1 = apply(map, uvs[corners[1]]);
  const Vec2f t2 = apply(map, uvs[corners[2]]);
  const auto [b1, b2] = hit.barycentric;
  return {t0.x + b1 * (t1.x - t0.x) + b2 * (t2.x - t0.x), t0.y + b1 * (t1.y - t0.y) + b2 * (t2.y - t0.y)};
}

std::optional<Vec3f> mapped_normal(const World& world, const NormalTexture& map, const Hit& hit, Vec3f n) {
  const auto directions = uv_directions_at(world, hit, map.uv);
  if (!directions) return std::nullopt;
  const auto frame = tangent_frame(n, *directions);
  if (!frame) return std::nullopt;
  const Vec3f texel =
      lookup(nth(world.textures, map.texture), map_at(world, hit, map.uv)) * 2 - Vec3f{1, 1, 1};
  return frame->along_u * (map.strength.x * texel.x) + frame->along_v * (map.strength.y * texel.y) +
         n * texel.z;
}

// n less the gradient of the height along the surface, times the area that one of u times one of v covers:
// (p_u + h_u n) x (p_v + h_v n), where p_u and p_v are those across the shading normal.
std::optional<Vec3f> bumped_normal(const World& world, const BumpTexture& map, const Hit& hit, Vec3f n) {
  const auto directions = uv_directions_at(world, hit, map.uv);
  if (!directions) return std::nullopt;
  const Vec2f slope = slope_of_red(nth(world.textures, map.texture), map_at(world, hit, map.uv));
  const Vec3f per_u = directions->along_u * directions->scale;
  const Vec3f per_v = directions->along_v * directions->scale;
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
