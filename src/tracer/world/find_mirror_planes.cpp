#include "tracer/world/find_mirror_planes.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace orbs::tracer {

namespace {

constexpr std::size_t kMostPlanes = 16;

// The plane of a triangle whose vertex normals equal its geometric normal, facing the side of the vertex
// normals.
std::optional<MirrorPlane> plane_of(const RenderObject& object, const TriangleCache& triangle) {
  if (!triangle.has_one_normal || triangle.geometric_normal == Vec3f{}) return std::nullopt;
  const bool instanced = object.kind == ObjectKind::InstancedMesh;
  const Vec3f corner = instanced ? apply_to_point(object.to_world, triangle.corner) : triangle.corner;
  const Vec3f edge1 = instanced ? apply_to_direction(object.to_world, triangle.edge1) : triangle.edge1;
  const Vec3f edge2 = instanced ? apply_to_direction(object.to_world, triangle.edge2) : triangle.edge2;
  const Vec3f shading =
      normalised(instanced ? apply_to_direction(object.normal_to_world, triangle.shading_normal)
                           : triangle.shading_normal);
  Vec3f normal = normalised(cross(edge1, edge2));
  if (dot(normal, shading) < 0) normal = -normal;
  const Vec3f apart = normal - shading;
  // Equal unit vectors differ by up to 1e-5 rad after rounding.
  if (dot(apart, apart) > 1e-10F) return std::nullopt;
  return MirrorPlane{normal, dot(normal, corner)};
}

// Triangles of one flat face agree up to rounding. Two faces that agree as well may be treated as one.
bool same_plane(const MirrorPlane& a, const MirrorPlane& b) {
  const Vec3f apart = a.normal - b.normal;
  return dot(apart, apart) < 1e-10F && std::abs(a.offset - b.offset) <= 1e-5F * (1 + std::abs(a.offset));
}

bool has_point_area_ies(const World& world) {
  return std::any_of(world.lights.begin(), world.lights.end(),
                     [](const AreaLight& light) { return light.ies && light.ies->point_area; });
}

int index_of(std::vector<MirrorPlane>& planes, const MirrorPlane& plane) {
  const auto found =
      std::find_if(planes.begin(), planes.end(), [&](const auto& p) { return same_plane(p, plane); });
  const auto index = static_cast<int>(found - planes.begin());
  if (found == planes.end()) planes.push_back(plane);
  return index;
}

// Stops once there are too many planes.
void find_in_object(World& world, RenderObject& object) {
  if (object.kind == ObjectKind::Light || is_analytic(object.kind)) return;
  const TriangleMesh& mesh = world.meshes[object.mesh];
  for (std::size_t i = 0; i < mesh.triangle_cache.size() && world.mirror_planes.size() <= kMostPlanes; ++i) {
    const int material = object.material_of[static_cast<std::size_t>(mesh.triangle_cache[i].material)];
    if (!std::holds_alternative<MirrorMaterial>(world.materials[static_cast<std::size_t>(material)].model))
      continue;
    const auto plane = plane_of(object, mesh.triangle_cache[i]);
    if (!plane) continue;
    object.mirror_planes.resize(mesh.triangle_cache.size(), -1);
    object.mirror_planes[i] = index_of(world.mirror_planes, *plane);
  }
}

}  // namespace

void find_mirror_planes(World& world) {
  if (world.emitters.empty() || has_point_area_ies(world)) return;
  for (RenderObject& object : world.objects) find_in_object(world, object);
  if (world.mirror_planes.size() <= kMostPlanes) return;
  world.mirror_planes.clear();
  for (RenderObject& object : world.objects) object.mirror_planes.clear();
}

}  // namespace orbs::tracer
