#include "adapters/lights_as_meshes.h"

#include "adapters/light_frame.h"
#include "scene/geometry/generators.h"
#include "scene/geometry/world_bounds.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace orbs::adapters {

namespace {

constexpr int kSegments = 128;
constexpr double kCasingDistance = 1e-4;  // of the light's smaller half size

/// What stands in the place of a light, about its centre.
struct LightMeshes {
  scene::Mesh front;
  scene::Mesh casing;
};

// Corners of a flat light about its centre, counter-clockwise seen from where it shines.
using Outline = std::vector<Vec3d>;

Outline outline_of(const scene::RectShape& rect, const LightFrame& frame) {
  const Vec3d u = frame.u * rect.half_width_m;
  const Vec3d v = frame.v * rect.half_length_m;
  return {-u - v, u - v, u + v, v - u};
}

// A regular polygon of n corners has the area n/2 r^2 sin(2 pi / n).
Outline outline_of(const scene::DiskShape& disk, const LightFrame& frame) {
  constexpr double kStep = 2 * std::numbers::pi / kSegments;
  const double r = disk.radius_m * std::sqrt(kStep / std::sin(kStep));
  Outline outline;
  for (int i = 0; i < kSegments; ++i)
    outline.push_back(frame.u * (r * std::cos(kStep * i)) + frame.v * (r * std::sin(kStep * i)));
  return outline;
}

void add_fan(scene::Mesh& mesh, Vec3d middle, const Outline& outline, Vec3d normal) {
  const auto first = add_vertex(mesh, middle, normal, {});
  for (const Vec3d corner : outline) add_vertex(mesh, corner, normal, {});
  const auto count = static_cast<std::uint32_t>(outline.size());
  for (std::uint32_t i = 0; i < count; ++i)
    mesh.triangles.push_back({first, first + 1 + i, first + 1 + (i + 1) % count});
}

// The strip of quads between the outline and the same one at `behind`.
void add_rim(scene::Mesh& mesh, const Outline& outline, Vec3d behind, Vec3d facing) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec3d a = outline[i];
    const Vec3d b = outline[(i + 1) % outline.size()];
    const Vec3d outwards = normalised(cross(b - a, facing));
    const auto first = add_vertex(mesh, a + behind, outwards, {});
    for (const Vec3d corner : {b + behind, b, a}) add_vertex(mesh, corner, outwards, {});
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
  }
}

template <typename Flat>
LightMeshes meshes_of(const Flat& shape, const LightFrame& frame) {
  const Outline outline = outline_of(shape, frame);
  const Vec3d half = half_size(shape);
  const double smaller = std::min(half.x * length(frame.u), half.z * length(frame.v));
  const Vec3d behind = frame.facing * (-kCasingDistance * smaller);
  LightMeshes meshes;
  add_fan(meshes.front, {}, outline, frame.facing);
  Outline back(outline.rbegin(), outline.rend());
  for (Vec3d& corner : back) corner += behind;
  add_fan(meshes.casing, behind, back, -frame.facing);
  add_rim(meshes.casing, outline, behind, frame.facing);
  return meshes;
}

double area_m2(const scene::Mesh& mesh) {
  double sum = 0;
  for (const auto& triangle : mesh.triangles) {
    const Vec3d a = cast<double>(mesh.positions[triangle[0]]);
    sum += length(cross(cast<double>(mesh.positions[triangle[1]]) - a,
                        cast<double>(mesh.positions[triangle[2]]) - a)) /
           2;
  }
  return sum;
}

// The mean shadow of a convex body is a quarter of its surface (Cauchy), so a sphere that keeps its area
// keeps the light that it sends, on average over all directions.
LightMeshes meshes_of(const scene::WithoutArea auto&, const LightFrame&) { return {}; }

LightMeshes meshes_of(const scene::SphereShape& sphere, const LightFrame& frame) {
  const scene::Mesh unit = scene::make_sphere({1, kSegments});
  const double r = sphere.radius_m * length(frame.u) * std::sqrt(4 * std::numbers::pi / area_m2(unit));
  const auto scaled = [&](double factor) {
    scene::Mesh mesh = unit;
    for (Vec3f& p : mesh.positions) p = cast<float>(cast<double>(p) * factor);
    return mesh;
  };
  return {scaled(r), scaled(r * (1 - kCasingDistance))};
}

int add_material(scene::Scene& scene, scene::Material material) {
  scene.materials.push_back(std::move(material));
  return static_cast<int>(scene.materials.size()) - 1;
}

void add_instance(scene::Scene& scene, scene::Mesh mesh, int material, const Mat4& place) {
  mesh.triangle_materials.assign(mesh.triangles.size(), material);
  scene.instances.push_back({mesh.name, static_cast<int>(scene.meshes.size()), place, {}});
  scene.meshes.push_back(std::move(mesh));
}

void replace_lights(scene::Scene& scene) {
  const auto is_drawn = [](const scene::Light& light) { return has_area(light.shape); };
  if (std::none_of(scene.lights.begin(), scene.lights.end(), is_drawn)) return;
  const int black = add_material(scene, {"casing of lights", scene::Lambert{}});
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const scene::Light& light = scene.lights[i];
    if (!is_drawn(light)) continue;
    const auto name = scene::display_name("light", light.name, i);
    const LightFrame frame = light_frame(light.matrix);
    auto meshes = std::visit([&](const auto& shape) { return meshes_of(shape, frame); }, light.shape);
    meshes.front.name = name;
    meshes.casing.name = "casing of " + name;
    const int shining =
        add_material(scene, {name, scene::Emission{light.radiance, std::nullopt, light.spectrum}});
    add_instance(scene, std::move(meshes.front), shining, translation(frame.centre));
    add_instance(scene, std::move(meshes.casing), black, translation(frame.centre));
  }
  std::erase_if(scene.lights, is_drawn);
}

void replace_environment(scene::Scene& scene) {
  if (scene.environment.radiance == scene::RgbColour{}) return;
  const Vec3d eye = scene.camera.position_m;
  const auto drawn = rough_bounds(scene);
  const auto bounds = drawn ? joined(*drawn, {eye, eye}) : scene::WorldBounds{eye, eye};
  const double radius = radius_of(bounds);
  const double half = radius > 0 ? 2 * radius : 1;
  scene::Mesh box = scene::make_cube({1});
  box.name = "environment";
  const int shining = add_material(
      scene,
      {"environment", scene::Emission{scene.environment.radiance, std::nullopt, scene.environment.spectrum}});
  add_instance(scene, std::move(box), shining,
               translation((bounds.low + bounds.high) * 0.5) * scaling({half, half, half}));
  scene.environment.radiance = {};
  scene.environment.spectrum.reset();
}

}  // namespace

scene::Scene lights_as_meshes(scene::Scene scene) {
  replace_environment(scene);
  replace_lights(scene);
  return scene;
}

}  // namespace orbs::adapters
