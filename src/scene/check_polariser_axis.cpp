#include "scene/check_polariser_axis.h"

#include <fmt/format.h>

namespace orbs::scene {

namespace {

// Below this sine the projected axis is nothing but the rounding of the vertices' floats.
constexpr double kLeastSine = 1e-4;

std::string axis_problem(const Scene& scene, Vec3d axis, int material) {
  for (const auto& instance : scene.instances) {
    const auto& mesh = mesh_of(scene, instance);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      if (remapped(instance, mesh.triangle_materials[i]) != material) continue;
      const auto corner = [&](std::size_t k) {
        return transform_point(instance.matrix, cast<double>(mesh.positions[mesh.triangles[i][k]]));
      };
      const Vec3d normal = cross(corner(1) - corner(0), corner(2) - corner(0));
      if (length(normal) == 0 || length(cross(normal, axis)) > kLeastSine * length(normal) * length(axis))
        continue;
      return fmt::format("the axis ({}, {}, {}) stands perpendicular to triangle {} of instance '{}'", axis.x,
                         axis.y, axis.z, i, instance.name);
    }
  }
  for (std::size_t i = 0; i < scene.spheres.size(); ++i)
    if (scene.spheres[i].material == material)
      return fmt::format(
          "{} is a sphere and no thin optical element: an axis can be projected into flat surfaces only",
          display_name("shape", scene.spheres[i].name, i));
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    bool is_shown = false;
    for_each_leaf(scene.shapes[i], scene.shapes[i].material,
                  [&](const Shape&, int own) { is_shown = is_shown || own == material; });
    if (is_shown)
      return fmt::format(
          "{} is {} and no thin optical element: an axis can be projected into the flat surfaces of meshes only",
          display_name("shape", scene.shapes[i].name, scene.spheres.size() + i),
          what_is(scene.shapes[i].form));
  }
  return "";
}

}  // namespace

std::string check_polariser_axis(const Scene& scene, int material) {
  return std::visit(
      [&](const auto& model) -> std::string {
        if constexpr (requires { model.axis; }) return axis_problem(scene, model.axis, material);
        return "";
      },
      material_at(scene, material).model);
}

}  // namespace orbs::scene
