#include "tracer/world/specular_objects.h"

#include "base/nth.h"
#include "tracer/geometry/box.h"
#include "tracer/numeric_fault.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace orbs::tracer {

namespace {

constexpr std::size_t kMostCasters = 16;

template <typename F>
void for_each_near_specular_corner(const World& world, const RenderObject& object, const F& visit) {
  if (object.kind == ObjectKind::Light || is_analytic(object.kind)) return;
  const TriangleMesh& mesh = world.meshes[object.mesh];
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const int material = nth(object.material_of, mesh.materials[i]);
    if (!nth(world.materials, material).is_near_specular) continue;
    for (const auto corner : mesh.triangles[i]) {
      const Vec3f local = mesh.positions[corner];
      visit(object.kind == ObjectKind::InstancedMesh ? apply_to_point(object.to_world, local) : local);
    }
  }
}

std::optional<BoundingSphere> sphere_about(const World& world, const Solid& solid) {
  const bool is_caster = std::any_of(solid.leaves.begin(), solid.leaves.end(), [&](const SolidLeaf& leaf) {
    return nth(world.materials, leaf.material).is_near_specular;
  });
  if (!is_caster) return std::nullopt;
  const Vec3d centre = (solid.low + solid.high) * 0.5;
  return BoundingSphere{cast<float>(centre), static_cast<float>(length(solid.high - centre))};
}

std::optional<BoundingSphere> sphere_about(const World& world, const PluginShape& shape) {
  if (!nth(world.materials, shape.material).is_near_specular) return std::nullopt;
  const Vec3d centre = (shape.low + shape.high) * 0.5;
  return BoundingSphere{cast<float>(centre), static_cast<float>(length(shape.high - centre))};
}

std::optional<BoundingSphere> sphere_about(const World& world, const RenderObject& object) {
  if (object.kind == ObjectKind::PluginShape)
    return sphere_about(world, world.plugin_shapes[object.plugin_shape]);
  if (object.kind == ObjectKind::Solid) return sphere_about(world, world.solids[object.solid]);
  if (object.kind == ObjectKind::Sphere) {
    const SphereSurface& sphere = world.spheres[object.sphere];
    if (!nth(world.materials, sphere.material).is_near_specular) return std::nullopt;
    return BoundingSphere{cast<float>(sphere.centre), static_cast<float>(sphere.radius)};
  }
  Box box;
  for_each_near_specular_corner(world, object, [&](Vec3f p) { box.add(p); });
  if (box.empty()) return std::nullopt;
  BoundingSphere sphere{box.centre(), 0};
  for_each_near_specular_corner(
      world, object, [&](Vec3f p) { sphere.radius = std::max(sphere.radius, length(p - sphere.centre)); });
  return sphere;
}

BoundingSphere sphere_about(const std::vector<BoundingSphere>& spheres) {
  Box box;
  for (const auto& s : spheres) {
    const Vec3f r{s.radius, s.radius, s.radius};
    box.add(s.centre - r);
    box.add(s.centre + r);
  }
  BoundingSphere all{box.centre(), 0};
  for (const auto& s : spheres) all.radius = std::max(all.radius, length(s.centre - all.centre) + s.radius);
  return all;
}

}  // namespace

std::vector<BoundingSphere> find_caustic_casters(const World& world) {
  std::vector<BoundingSphere> casters;
  for (const RenderObject& object : world.objects)
    if (const auto sphere = sphere_about(world, object)) casters.push_back(*sphere);
  if (casters.size() > kMostCasters) casters = {sphere_about(casters)};
  return casters;
}

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
  const float most = has_fault(NumericFault::MirrorsMerged) ? 1e-2F : 1e-5F * (1 + std::abs(a.offset));
  return dot(apart, apart) < 1e-10F && std::abs(a.offset - b.offset) <= most;
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

bool turns_normals(const World& world, int material) {
  if (world.normal_details.empty()) return false;
  const auto& [normal, bump] = nth(world.normal_details, material);
  return normal.texture >= 0 || bump.texture >= 0;
}

// Stops once there are too many planes.
void find_in_object(World& world, RenderObject& object) {
  if (object.kind != ObjectKind::WorldMesh && object.kind != ObjectKind::InstancedMesh) return;
  const TriangleMesh& mesh = world.meshes[object.mesh];
  for (std::size_t i = 0; i < mesh.triangle_cache.size() && world.mirror_planes.size() <= kMostPlanes; ++i) {
    const int material = nth(object.material_of, mesh.triangle_cache[i].material);
    if (!std::holds_alternative<MirrorMaterial>(nth(world.materials, material).model)) continue;
    if (turns_normals(world, material)) continue;
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
