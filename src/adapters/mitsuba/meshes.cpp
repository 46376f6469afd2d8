#include "adapters/mitsuba/meshes.h"

#include "adapters/material_meshes.h"

#include <algorithm>
#include <array>
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

scene::Mesh polariser_mesh(Vec3d axis, const scene::Mesh& mesh, const Mat4& place) {
  const Mat4 back = inverse(place).value();  // the loader lets only invertible matrices through
  scene::Mesh flat;
  flat.name = mesh.name;
  for (const auto& triangle : mesh.triangles) {
    std::array<Vec3d, 3> corner;
    for (std::size_t i = 0; i < 3; ++i)
      corner[i] = transform_point(place, cast<double>(mesh.positions[triangle[i]]));
    const Vec3d normal = normalised(cross(corner[1] - corner[0], corner[2] - corner[0]));
    const Vec3d u = normalised(axis - normal * dot(axis, normal));
    const Vec3d v = cross(normal, u);
    const auto first = static_cast<std::uint32_t>(flat.positions.size());
    for (std::size_t i = 0; i < 3; ++i) {
      // Distances are measured from the first corner: far from the origin the direction would be lost to
      // rounding of floats.
      const Vec3d from_first = corner[i] - corner[0];
      flat.positions.push_back(cast<float>(corner[i]));
      flat.normals.push_back(
          cast<float>(normalised(transform_normal(back, cast<double>(mesh.normals[triangle[i]])))));
      flat.tangents.emplace_back();
      flat.uvs.push_back({static_cast<float>(dot(from_first, u)), static_cast<float>(dot(from_first, v))});
    }
    flat.triangles.push_back({first, first + 1, first + 2});
  }
  flat.triangle_materials.assign(flat.triangles.size(), 0);
  return flat;
}

}  // namespace orbs::adapters::mitsuba
