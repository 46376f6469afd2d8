#include "scene/relations/ground.h"

#include "scene/camera_frame.h"
#include "scene/geometry/world_bounds.h"
#include "scene/motion.h"

#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

struct Ground {
  std::size_t instance = 0;
  WorldBounds bounds;
  std::optional<WorldBounds> others;  // all that is drawn but the ground
};

bool is_opaque_and_plain(const Scene& scene, const Instance& instance) {
  for (const int material : mesh_of(scene, instance).triangle_materials) {
    const auto& [name, model, detail] = material_at(scene, remapped(instance, material));
    const bool is_opaque = std::holds_alternative<Lambert>(model) ||
                           std::holds_alternative<OrenNayar>(model) ||
                           std::holds_alternative<Mirror>(model) || std::holds_alternative<Ggx>(model);
    if (!is_opaque || texture_of(model) || detail != SurfaceDetail{}) return false;
  }
  return true;
}

WorldBounds bounds_without(Scene scene, std::size_t instance) {
  scene.instances.erase(scene.instances.begin() + static_cast<std::ptrdiff_t>(instance));
  return world_bounds(scene).value_or(WorldBounds{});
}

// The largest of the instances that can be the ground.
std::optional<Ground> find_ground(const Scene& scene) {
  std::optional<Ground> ground;
  const auto all = world_bounds(scene);
  if (!all) return ground;
  const double rounding = 1e-6 * radius_of(*all);
  const Camera& camera = scene.camera;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const auto bounds = world_bounds(scene, scene.instances[i]);
    const bool is_level = bounds.high.y - bounds.low.y <= rounding;
    const bool is_lowest = bounds.low.y <= all->low.y + rounding;
    if (is_moving(scene, scene.instances[i])) continue;
    if (!is_level || !is_lowest || !is_opaque_and_plain(scene, scene.instances[i])) continue;
    if (std::fmin(camera.position_m.y, camera.end ? camera.end->position_m.y : camera.position_m.y) <=
        bounds.high.y)
      continue;
    if (!ground || radius_of(bounds) > radius_of(ground->bounds)) ground = Ground{i, bounds, {}};
  }
  if (ground && scene.instances.size() + scene.spheres.size() + scene.shapes.size() + scene.lights.size() > 1)
    ground->others = bounds_without(scene, ground->instance);
  return ground;
}

constexpr const char* kNoGround =
    "no level, opaque instance without texture lies below all else and below the camera";

Vec3d middle_of(const WorldBounds& bounds) { return (bounds.low + bounds.high) * 0.5; }

Mat4 widened(const Ground& ground, const Mat4& matrix, double factor) {
  const Vec3d centre = middle_of(ground.bounds);
  return translation(centre) * scaling({factor, 1, factor}) * translation(-centre) * matrix;
}

}  // namespace

std::variant<Scene, std::string> with_large_ground(const Scene& scene, double ratio) {
  const auto ground = find_ground(scene);
  if (!ground) return kNoGround;
  // A point of light alone has no size that a ground could be larger than.
  if (!ground->others || !(radius_of(*ground->others) > 0)) return "it has nothing but a ground";
  if (shines(scene.environment) || scene.environment.spectrum)
    return "its environment shines, and a larger ground hides more of it: its edge is a horizon in view";
  Scene out = scene;
  out.trace_depth = 1;
  const Vec3d extent = ground->bounds.high - ground->bounds.low;
  const double half_size = 0.5 * std::fmin(extent.x, extent.z);
  auto& matrix = out.instances[ground->instance].matrix;
  matrix = widened(*ground, matrix, ratio * radius_of(*ground->others) / half_size);
  return out;
}

std::variant<Scene, std::string> with_sheet_below_ground(const Scene& scene, double gap_m) {
  const auto ground = find_ground(scene);
  if (!ground) return kNoGround;
  Scene out = scene;
  const int black = static_cast<int>(out.materials.size());
  out.materials.push_back({"hidden black", Lambert{}});
  Instance sheet = scene.instances[ground->instance];
  Mesh mesh = mesh_of(scene, sheet);
  mesh.name = "hidden sheet";
  mesh.triangle_materials.assign(mesh.triangles.size(), black);
  sheet.name = "hidden sheet";
  sheet.mesh = static_cast<int>(out.meshes.size());
  sheet.remap.clear();
  sheet.matrix = translation({0, -gap_m, 0}) * widened(*ground, sheet.matrix, 0.5);
  out.meshes.push_back(std::move(mesh));
  out.instances.push_back(std::move(sheet));
  return out;
}

std::variant<Scene, std::string> with_far_camera(const Scene& scene, double factor) {
  if (!is_plain_pinhole(scene.camera)) return "its camera is no pinhole with a centred image";
  constexpr double kFinest_rad = 1e-6;  // as the reader of scenes demands
  Scene out = scene;
  auto& camera = out.camera;
  const auto frame = camera_frame(camera);
  const double half_height = frame.half_height / factor;
  if (2 * half_height / camera.height_px < kFinest_rad)
    return fmt::format("its pixels would be finer than {} rad", kFinest_rad);
  const double distance = length(camera.look_at_m - camera.position_m);
  camera.position_m = camera.look_at_m - frame.forward * (distance * factor);
  camera.fov_y_deg = 2 * std::atan(half_height) * 180 / std::numbers::pi;
  return out;
}

}  // namespace orbs::scene
