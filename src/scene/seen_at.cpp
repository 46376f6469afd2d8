#include "scene/seen_at.h"

#include "scene/camera_frame.h"
#include "scene/lower/geometry.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

// A ray against a triangle takes about 10 ns, so that 25 points take about a second.
constexpr std::size_t kMostTriangles = 4'000'000;

// The nearest surface of each ray so far.
struct Nearest {
  double distance = std::numeric_limits<double>::infinity();
  std::string name;
};

// A name, made only for the surfaces that are nearest.
std::string instance_name(const Scene& scene, const Instance& instance, int material) {
  const auto& mesh = mesh_of(scene, instance);
  const auto name = instance.name.empty() ? mesh.name : instance.name;
  const bool has_one =
      std::all_of(mesh.triangle_materials.begin(), mesh.triangle_materials.end(),
                  [&](int other) { return remapped(instance, other) == remapped(instance, material); });
  const auto& called = material_at(scene, remapped(instance, material)).name;
  return has_one || called.empty() ? name : fmt::format("{} ({})", name, called);
}

// Where a ray meets a triangle, in lengths of its direction: Cramer's rule for
// d t = b0 v0 + b1 v1 + b2 v2 with b0 + b1 + b2 = 1, the corners v relative to the ray's origin.
std::optional<double> meet(const std::array<Vec3d, 3>& corners, const CameraRay& ray) {
  const std::array v{corners[0] - ray.origin_m, corners[1] - ray.origin_m, corners[2] - ray.origin_m};
  const Vec3d d = ray.direction;
  const double volume = dot(v[0], cross(v[1], v[2]));
  const double b0 = dot(d, cross(v[1], v[2])) / volume;
  const double b1 = dot(d, cross(v[2], v[0])) / volume;
  const double b2 = dot(d, cross(v[0], v[1])) / volume;
  // Written so that it is false for a triangle that is seen edge-on, whose volume is 0.
  if (!(b0 >= 0 && b1 >= 0 && b2 >= 0 && b0 + b1 + b2 > 0)) return std::nullopt;
  return 1 / (b0 + b1 + b2);
}

void meet_instance(const Scene& scene,
                   const Instance& instance,
                   const std::vector<CameraRay>& rays,
                   std::vector<Nearest>& nearest) {
  const auto& mesh = mesh_of(scene, instance);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<Vec3d, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners.at(k) = transform_point(instance.matrix, cast<double>(mesh.positions[mesh.triangles[t].at(k)]));
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const auto distance = meet(corners, rays[i]);
      if (distance && *distance < nearest[i].distance)
        nearest[i] = {*distance, instance_name(scene, instance, mesh.triangle_materials[t])};
    }
  }
}

void meet_light(const Light& light,
                std::size_t place,
                const std::vector<CameraRay>& rays,
                std::vector<Nearest>& nearest) {
  const Mat4 to_local = inverse(light.matrix).value();
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto found = std::visit(
        [&](const auto& shape) {
          return hit(shape, transform_point(to_local, rays[i].origin_m),
                     transform_direction(to_local, rays[i].direction));
        },
        light.shape);
    if (found.distance < nearest[i].distance)
      nearest[i] = {found.distance, display_name("light", light.name, place)};
  }
}

std::vector<CameraRay> rays_through(const Camera& camera, const std::vector<ImagePoint>& points) {
  const auto frame = camera_frame(camera);
  std::vector<CameraRay> rays;
  rays.reserve(points.size());
  for (const auto& [x, y] : points) rays.push_back(camera_ray(camera, frame, x, y));
  return rays;
}

std::size_t triangle_count(const Scene& scene) {
  std::size_t count = 0;
  for (const auto& instance : scene.instances) count += mesh_of(scene, instance).triangles.size();
  return count;
}

std::string of_most(const Nearest* first, std::size_t count) {
  std::map<std::string, std::size_t> counts;
  for (std::size_t i = 0; i < count; ++i) ++counts[first[i].name];
  for (const auto& [name, times] : counts)
    if (2 * times >= count) return name;
  return "";
}

}  // namespace

std::vector<std::string> seen_by_most(const Scene& given,
                                      const std::vector<std::vector<ImagePoint>>& regions) {
  std::vector<std::string> names(regions.size());
  auto scene = given;
  tessellate_spheres(scene);
  for (const auto* level : {"S1", "S2"}) tessellate_shapes(scene, level);
  if (!scene.shapes.empty() || triangle_count(scene) > kMostTriangles) return names;
  std::vector<ImagePoint> points;
  for (const auto& region : regions) points.insert(points.end(), region.begin(), region.end());
  const auto rays = rays_through(scene.camera, points);
  std::vector<Nearest> nearest(rays.size());
  for (const auto& instance : scene.instances) meet_instance(scene, instance, rays, nearest);
  for (std::size_t i = 0; i < scene.lights.size(); ++i) meet_light(scene.lights[i], i, rays, nearest);
  const auto* first = nearest.data();
  for (std::size_t i = 0; i < regions.size(); first += regions[i].size(), ++i)
    names[i] = of_most(first, regions[i].size());
  return names;
}

}  // namespace orbs::scene
