#include "tracer/world/uv_directions.h"

namespace orbs::tracer {

std::optional<UvDirections> uv_directions_at(const World& world, const Hit& hit, const UvMap& map) {
  const RenderObject& object = world.objects[hit.object];
  if (object.kind != ObjectKind::WorldMesh && object.kind != ObjectKind::InstancedMesh) return std::nullopt;
  const TriangleMesh& mesh = world.meshes[object.mesh];
  const std::vector<Vec2f>& uvs = uvs_of(mesh, map.set);
  const auto& corners = mesh.triangles[hit.primitive];
  const TriangleCache& triangle = mesh.triangle_cache[hit.primitive];
  const Vec2f t0 = apply(map, uvs[corners[0]]);
  const Vec2f t1 = apply(map, uvs[corners[1]]);
  const Vec2f t2 = apply(map, uvs[corners[2]]);
  auto directions =
      uv_directions(triangle.edge1, triangle.edge2, {t1.x - t0.x, t1.y - t0.y}, {t2.x - t0.x, t2.y - t0.y});
  if (!directions || object.kind == ObjectKind::WorldMesh) return directions;
  directions->along_u = apply_to_direction(object.to_world, directions->along_u);
  directions->along_v = apply_to_direction(object.to_world, directions->along_v);
  return directions;
}

}  // namespace orbs::tracer
