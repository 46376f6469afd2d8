#include "adapters/obj/world_parts.h"

#include "adapters/material_meshes.h"
#include "base/text.h"
#include "scene/lower/geometry.h"

#include <set>
#include <utility>

#include <fmt/format.h>

namespace orbs::adapters::obj {

namespace {

// The steps of lower() for renderers that have no matrices, on this mesh alone.
scene::Mesh placed(const scene::Mesh& mesh, const Mat4& place) {
  scene::Scene alone;
  alone.meshes = {mesh};
  alone.instances = {{mesh.name, 0, place, {}}};
  scene::merge_into_world_mesh(alone);
  return std::move(alone.meshes.front());
}

std::string plain(const std::string& name) {
  std::string text;
  for (const char c : name) text += is_letter_or_digit(c) || c == '-' ? c : '_';
  return text.substr(0, kMostNameCharacters);
}

}  // namespace

std::vector<std::string> plain_names(const std::vector<std::string>& names) {
  std::set<std::string> used;
  std::vector<std::string> out;
  for (std::size_t i = 0; i < names.size(); ++i) {
    auto name = names[i].empty() ? fmt::format("{}", i) : plain(names[i]);
    while (!used.insert(name).second) name += fmt::format("-{}", i);
    out.push_back(std::move(name));
  }
  return out;
}

std::vector<std::string> material_names(const scene::Scene& scene) {
  std::vector<std::string> names;
  for (const auto& material : scene.materials) names.push_back(material.name);
  return plain_names(names);
}

std::vector<WorldPart> world_parts(const scene::Scene& scene) {
  std::vector<WorldPart> parts;
  std::vector<std::string> names;
  for (const MaterialMesh& shown : material_meshes(scene))
    for (const Mat4& place : shown.places) {
      parts.push_back({"", shown.material, placed(shown.mesh, place)});
      names.push_back(shown.mesh.name);
    }
  names = plain_names(names);
  for (std::size_t i = 0; i < parts.size(); ++i) parts[i].name = names[i];
  return parts;
}

}  // namespace orbs::adapters::obj
