#include "scene/load/detail_checks.h"

#include "image/image_io.h"
#include "scene/motion.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

bool holds_colours(const Texture& texture) {
  return texture.encoding == Encoding::Srgb && !image::is_float_format(texture.file);
}

std::string colour_problem(const Scene& scene, const TextureUse& use) {
  const Texture& texture = texture_at(scene, use);
  if (!holds_colours(texture)) return "";
  return fmt::format(
      "texture '{}' holds sRGB colours, and numbers are wanted: give it \"encoding\": \"linear\"",
      texture.name);
}

// The shape by its formula that shows the material; "" if none does.
std::string shown_by_shape(const Scene& scene, int material) {
  for (std::size_t i = 0; i < scene.spheres.size(); ++i)
    if (scene.spheres[i].material == material) return display_name("shape", scene.spheres[i].name, i);
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    bool shows = false;
    for_each_leaf(scene.shapes[i], 0,
                  [&](const Shape& leaf, int) { shows = shows || leaf.material == material; });
    if (shows || scene.shapes[i].material == material)
      return display_name("shape", scene.shapes[i].name, scene.spheres.size() + i);
  }
  return "";
}

std::string shown_by_problem(const Scene& scene, int material) {
  const std::string name = shown_by_shape(scene, material);
  return name.empty() ? "" : name + " is a shape by its formula: meshes alone show opacity and other normals";
}

// Instances that move while the shutter is open and show the material with other normals.
std::string moving_problem(const Scene& scene, int material) {
  for (const auto& instance : scene.instances) {
    if (!is_moving(scene, instance)) continue;
    const auto& own = mesh_of(scene, instance).triangle_materials;
    for (const int given : std::set<int>(own.begin(), own.end()))
      if (remapped(instance, given) == material)
        return fmt::format("instance '{}' moves: what moves has no other normals", instance.name);
  }
  return "";
}

// Itself, or by a part of a blend.
bool asks_for_second_uvs(const Scene& scene, int index) {
  const auto uses = shown_texture_uses(scene.materials, index);
  return std::any_of(uses.begin(), uses.end(), [](const TextureUse& use) { return use.uv_set != 0; });
}

}  // namespace

std::string detail_problem(const Scene& scene, int material, std::string& key) {
  const Material& given = material_at(scene, material);
  const SurfaceDetail& detail = given.detail;
  if (detail == SurfaceDetail{}) return "";
  key = lets_rays_pass(detail) ? "opacity" : detail.normal_map ? "normal_map" : "bump_map";
  if (std::holds_alternative<Emission>(given.model))
    return "what emits has none: its light would pass through itself";
  const auto colours = [&](const char* of, const TextureUse& use) {
    key = of;
    return colour_problem(scene, use);
  };
  std::string problem;
  if (detail.opacity_texture) problem = colours("opacity_texture", *detail.opacity_texture);
  if (problem.empty() && detail.normal_map) problem = colours("normal_map", detail.normal_map->texture);
  if (problem.empty() && detail.bump_map) problem = colours("bump_map", detail.bump_map->texture);
  if (problem.empty()) problem = shown_by_problem(scene, material);
  if (problem.empty() && turns_normals(detail) && has_motion(scene))
    problem = moving_problem(scene, material);
  return problem;
}

std::string uv_set_problem(const Scene& scene, int material) {
  if (!asks_for_second_uvs(scene, material)) return "";
  if (const auto name = shown_by_shape(scene, material); !name.empty())
    return fmt::format(
        "asks for second texture coordinates, and {} is a shape by its formula, which has none", name);
  for (const auto& instance : scene.instances) {
    const Mesh& mesh = mesh_of(scene, instance);
    if (!mesh.second_uvs.empty()) continue;
    for (const int given : std::set<int>(mesh.triangle_materials.begin(), mesh.triangle_materials.end()))
      if (remapped(instance, given) == material)
        return fmt::format("asks for second texture coordinates, and mesh '{}' has no 'second_uvs'",
                           mesh.name);
  }
  return "";
}

}  // namespace orbs::scene
