#include "adapters/mitsuba/emitting_mesh.h"

#include "adapters/closed_mesh.h"

#include <algorithm>
#include <utility>

namespace orbs::adapters::mitsuba {

namespace {

void turn(std::array<std::uint32_t, 3>& triangle) { std::swap(triangle[1], triangle[2]); }

scene::Mesh wound_towards(Vec3d eye_m, scene::Mesh mesh, const Mat4& place) {
  for (auto& triangle : mesh.triangles) {
    const auto corner = [&](std::size_t i) {
      return transform_point(place, cast<double>(mesh.positions[triangle[i]]));
    };
    const Vec3d a = corner(0);
    if (dot(cross(corner(1) - a, corner(2) - a), eye_m - a) < 0) turn(triangle);
  }
  return mesh;
}

// A mirroring matrix reverses the winding in the world.
scene::Mesh wound_outwards(scene::Mesh mesh, const Mat4& place) {
  if (is_wound_outwards(mesh) == (determinant3(place) > 0)) return mesh;
  for (auto& triangle : mesh.triangles) turn(triangle);
  return mesh;
}

}  // namespace

bool only_camera_sees_light(const scene::Scene& scene) {
  const auto visible = scene::visible_materials(scene);
  return std::all_of(
             visible.begin(), visible.end(),
             [&](int i) { return std::holds_alternative<scene::Emission>(material_at(scene, i).model); }) &&
         std::all_of(scene.lights.begin(), scene.lights.end(),
                     [](const auto& light) { return light.reflectance == scene::RgbColour{}; });
}

scene::Mesh emitting_mesh(const scene::Scene& scene, scene::Mesh mesh, const Mat4& place) {
  return only_camera_sees_light(scene) ? wound_towards(scene.camera.position_m, std::move(mesh), place)
                                       : wound_outwards(std::move(mesh), place);
}

}  // namespace orbs::adapters::mitsuba
