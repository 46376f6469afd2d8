#include "tracer/light/caustic_casters.h"

#include "tracer/geometry/frame.h"
#include "tracer/world/materials.h"
#include "tracer/sampling/warps.h"
#include "tracer/world/world.h"

#include <algorithm>
#include <optional>

namespace orbs::tracer {

namespace {

constexpr std::size_t kMostCasters = 16;
// Above this roughness the lobe is wide enough for light sampling at the surface itself.
constexpr float kNearSpecularAlpha = 0.3F;

class Box {
 public:
  void add(Vec3f p) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y), std::max(high_.z, p.z)};
  }
  bool empty() const { return low_.x > high_.x; }
  Vec3f centre() const { return (low_ + high_) * 0.5F; }

 private:
  Vec3f low_{INFINITY, INFINITY, INFINITY};
  Vec3f high_{-INFINITY, -INFINITY, -INFINITY};
};

template <typename F>
void for_each_near_specular_corner(const World& world, const RenderObject& object, const F& visit) {
  if (object.kind == ObjectKind::Light || object.kind == ObjectKind::Sphere) return;
  const TriangleMesh& mesh = world.meshes[object.mesh];
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const int material = object.material_of[static_cast<std::size_t>(mesh.materials[i])];
    if (!is_near_specular(world.materials[static_cast<std::size_t>(material)])) continue;
    for (const auto corner : mesh.triangles[i]) {
      const Vec3f local = mesh.positions[corner];
      visit(object.kind == ObjectKind::InstancedMesh ? apply_to_point(object.to_world, local) : local);
    }
  }
}

std::optional<BoundingSphere> sphere_about(const World& world, const RenderObject& object) {
  if (object.kind == ObjectKind::Sphere) {
    const SphereSurface& sphere = world.spheres[object.sphere];
    if (!is_near_specular(world.materials[static_cast<std::size_t>(sphere.material)])) return std::nullopt;
    return BoundingSphere{sphere.centre, sphere.radius};
  }
  Box box;
  for_each_near_specular_corner(world, object, [&](Vec3f p) { box.add(p); });
  if (box.empty()) return std::nullopt;
  BoundingSphere sphere{box.centre(), 0};
  for_each_near_specular_corner(world, object,
                        [&](Vec3f p) { sphere.radius = std::max(sphere.radius, length(p - sphere.centre)); });
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

// 1 - cos of the half angle that the sphere fills from `from`; nothing from within.
std::optional<float> cone_height(const BoundingSphere& sphere, Vec3f from) {
  const Vec3f d = sphere.centre - from;
  const float sin2 = sphere.radius * sphere.radius / dot(d, d);
  if (!(sin2 < 1)) return std::nullopt;
  return sin2 / (1 + std::sqrt(1 - sin2));
}

Vec3f sample_cone(Vec3f axis, float height, float u, float v) {
  const float down = u * height;
  const float sine = std::sqrt(down * (2 - down));
  const float phi = 2 * kPi * v;
  return frame_around(axis).to_world({sine * std::cos(phi), sine * std::sin(phi), 1 - down});
}

// `was_chosen`: the direction lies in this cone, whatever rounding says at its rim.
float density(const BoundingSphere& target, Vec3f from, Vec3f normal, Vec3f direction, bool was_chosen) {
  const auto height = cone_height(target, from);
  if (!height) return std::max(0.0F, dot(normal, direction)) * kInvPi;
  const Vec3f off_axis = direction - normalised(target.centre - from);
  const float down = dot(off_axis, off_axis) / 2;  // 1 - cos, without its cancellation
  return was_chosen || down <= *height ? 1 / (2 * kPi * *height) : 0;
}

}  // namespace

bool is_near_specular(const SurfaceMaterial& material) {
  if (is_smooth(material)) return true;
  switch (material.model) {
    case Model::Ggx:
    case Model::RoughGlass:
    case Model::Conductor:
    case Model::Dielectric:
      return material.alpha < kNearSpecularAlpha;
    default:
      return false;
  }
}

std::vector<BoundingSphere> find_caustic_casters(const World& world) {
  std::vector<BoundingSphere> targets;
  for (const RenderObject& object : world.objects)
    if (const auto sphere = sphere_about(world, object)) targets.push_back(*sphere);
  if (targets.size() > kMostCasters) targets = {sphere_about(targets)};
  return targets;
}

CasterDirection sample_towards_casters(
    const std::vector<BoundingSphere>& targets, Vec3f from, Vec3f normal, float pick, float u, float v) {
  const auto count = targets.size();
  const auto chosen = std::min(static_cast<std::size_t>(pick * static_cast<float>(count)), count - 1);
  const auto height = cone_height(targets[chosen], from);
  const Vec3f direction = height ? sample_cone(normalised(targets[chosen].centre - from), *height, u, v)
                                 : frame_around(normal).to_world(sample_cosine(u, v));
  float sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += density(targets[i], from, normal, direction, i == chosen);
  return {direction, sum / static_cast<float>(count)};
}

}  // namespace orbs::tracer
