#include "scene/relations/motion.h"

#include "base/nth.h"
#include "scene/geometry/world_bounds.h"
#include "scene/lower/geometry.h"
#include "scene/relations/light.h"

#include <cmath>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

bool is_reflection(const Mat4& motion) {
  const auto image = [&](Vec3d axis) { return transform_direction(motion, axis); };
  return dot(cross(image({1, 0, 0}), image({0, 1, 0})), image({0, 0, 1})) < 0;
}

void move_camera(Camera& camera, const Mat4& motion, double scale) {
  const auto move = [&](auto& view) {
    view.position_m = transform_point(motion, view.position_m);
    view.look_at_m = transform_point(motion, view.look_at_m);
    // Divided by the scale: only the direction matters, and its length must stay within that of a place.
    view.up = transform_direction(motion, view.up) / scale;
  };
  move(camera);
  if (camera.end) move(*camera.end);
  camera.near_m *= scale;
  camera.far_m *= scale;
  if (camera.focus_distance_m) *camera.focus_distance_m *= scale;
  camera.aperture_radius_m *= scale;
  std::visit([&](auto& kind) { orbs::scene::scale(kind, scale); }, camera.projection);
  // The camera's right turns around with its image.
  if (is_reflection(motion)) camera.shift.x = -camera.shift.x;
}

// Whether what a material looks like depends on the coordinates or on a direction along them.
bool follows_coordinates(const Scene& scene, int index) {
  const auto& material = material_at(scene, index);
  if (const auto* blend = std::get_if<Blend>(&material.model))
    for (const auto& part : blend->parts)
      if (follows_coordinates(scene, part.material)) return true;
  return !texture_uses(material).empty() || std::holds_alternative<AnisotropicGgx>(material.model);
}

}  // namespace

Scene moved(const Scene& scene, const Mat4& motion) {
  // A similarity stretches every vector alike.
  const double scale = length(transform_direction(motion, {1, 0, 0}));
  Scene out = scene;
  move_camera(out.camera, motion, scale);
  for (auto& instance : out.instances) {
    instance.matrix = motion * instance.matrix;
    if (instance.end_matrix) instance.end_matrix = motion * *instance.end_matrix;
  }
  for (auto& light : out.lights) {
    light.matrix = motion * light.matrix;
    multiply_emission(light, std::pow(scale, power_of_scale(light.shape)));
  }
  if (auto& map = out.environment.map) {
    map->matrix = motion * map->matrix;
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3; ++column) map->matrix(row, column) /= scale;
      map->matrix(row, 3) = 0;  // infinitely far away
    }
  }
  for (auto& sphere : out.spheres) {
    sphere.centre_m = transform_point(motion, sphere.centre_m);
    sphere.radius_m *= scale;
  }
  for (auto& shape : out.shapes) shape.matrix = motion * shape.matrix;
  for (auto& material : out.materials)
    if (material.detail.bump_map) material.detail.bump_map->height_m *= scale;
  if (auto* occlusion = std::get_if<AmbientOcclusion>(&out.integrator)) occlusion->distance_m *= scale;
  for (auto& material : out.materials)
    std::visit(
        [&](auto& model) {
          if constexpr (requires { model.axis; })
            model.axis = transform_direction(motion, model.axis) / scale;
          // Counter-clockwise becomes clockwise.
          if constexpr (requires { model.rotation_deg; })
            if (is_reflection(motion)) model.rotation_deg = -model.rotation_deg;
        },
        material.model);
  return out;
}

std::string turning_problem(const Scene& scene) {
  for (std::size_t i = 0; i < scene.spheres.size(); ++i)
    if (follows_coordinates(scene, scene.spheres[i].material))
      return fmt::format("{} has a texture or a grain, whose coordinates follow the axes of the world",
                         display_name("sphere", scene.spheres[i].name, i));
  return "";
}

Scene with_moved_vertices(const Scene& scene, Vec3d offset) {
  Scene out = moved(scene, translation(offset));
  out.meshes = scene.meshes;
  out.instances = scene.instances;
  merge_into_world_mesh(out);
  for (auto& instance : out.instances) {
    auto& mesh = nth(out.meshes, instance.mesh);
    std::vector<Vec3d> vertices;
    for (const Vec3f position : mesh.positions) vertices.push_back(cast<double>(position) + offset);
    auto placed = placed_vertices(vertices);
    mesh.positions = std::move(placed.positions);
    instance.matrix = translation(placed.origin_m);
  }
  return out;
}

}  // namespace orbs::scene
