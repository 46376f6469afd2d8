#include "adapters/parts.h"

#include "scene/lower_parts.h"

#include <algorithm>
#include <cctype>

namespace orbs::adapters {

namespace {

// Nothing would be seen of them, and a lamp must not be sampled there.
void drop_triangles_without_area(scene::Mesh& mesh) {
  std::erase_if(mesh.triangles, [&](const auto& triangle) {
    const Vec3d a = cast<double>(mesh.positions[triangle[0]]);
    const Vec3d normal =
        cross(cast<double>(mesh.positions[triangle[1]]) - a, cast<double>(mesh.positions[triangle[2]]) - a);
    return !(dot(normal, normal) > 0);
  });
  mesh.triangle_materials.resize(mesh.triangles.size());
}

}  // namespace

std::vector<Part> parts_of(const scene::Scene& scene) {
  scene::Scene split = scene;
  scene::bake_texture_matrices(split);
  scene::split_by_material(split);
  std::vector<Part> parts(split.meshes.size());
  for (const scene::Instance& instance : split.instances)
    parts[static_cast<std::size_t>(instance.mesh)].places.push_back(instance.matrix);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    parts[i].mesh = std::move(split.meshes[i]);
    if (!parts[i].mesh.triangle_materials.empty()) parts[i].material = parts[i].mesh.triangle_materials[0];
    drop_triangles_without_area(parts[i].mesh);
  }
  std::erase_if(parts, [](const Part& part) { return part.places.empty() || part.mesh.triangles.empty(); });
  return parts;
}

std::string one_line(const std::string& name) {
  std::string text = name;
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  return text;
}

}  // namespace orbs::adapters
