#include "scene/scene.h"

#include <fmt/format.h>

namespace orbs::scene {

int remapped(const Instance& instance, int material) {
  for (const auto& [from, to] : instance.remap)
    if (from == material) return to;
  return material;
}

std::set<int> visible_materials(const Scene& scene) {
  std::set<int> visible;
  for (const auto& instance : scene.instances) {
    const auto& materials = mesh_of(scene, instance).triangle_materials;
    for (const int material : std::set<int>(materials.begin(), materials.end()))
      visible.insert(remapped(instance, material));
  }
  for (const auto& sphere : scene.spheres) visible.insert(sphere.material);
  for (const auto& shape : scene.shapes)
    for_each_leaf(shape, shape.material, [&](const Shape&, int material) { visible.insert(material); });
  for (const int material : std::set<int>(visible))
    if (const auto* blend = std::get_if<Blend>(&material_at(scene, material).model))
      for (const auto& part : blend->parts) visible.insert(part.material);
  return visible;
}

std::string display_name(const char* kind, const std::string& name, std::size_t place) {
  return name.empty() ? fmt::format("{} {}", kind, place) : fmt::format("{} '{}'", kind, name);
}

}  // namespace orbs::scene
