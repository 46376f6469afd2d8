#include "scene/mirrored_frames.h"

#include "base/nth.h"
#include "scene/geometry/uv_frames.h"
#include "scene/lower/geometry.h"

#include <map>
#include <utility>
#include <vector>

namespace orbs::scene {

namespace {

bool mirrors(const Instance& instance) { return determinant3(instance.matrix) < 0; }

// Of an instance without a remap list, of this mesh.
bool has_wrong_frame(
    const Scene& scene, const Mesh& mesh, std::size_t triangle, bool is_mirrored_by_matrix, FrameSign known) {
  const auto& map = material_at(scene, mesh.triangle_materials[triangle]).detail.normal_map;
  if (!map) return false;
  const auto frame = uv_frame(mesh, triangle, map->texture.uv_set);
  if (!frame) return false;
  return known == FrameSign::OfMesh ? is_mirrored_by_matrix : is_mirrored(*frame) != is_mirrored_by_matrix;
}

bool shows_a_normal_map(const Scene& scene) {
  for (const Material& material : scene.materials)
    if (material.detail.normal_map) return true;
  return false;
}

}  // namespace

std::set<int> materials_in_wrong_frames(const Scene& scene, FrameSign known) {
  std::set<int> found;
  if (!shows_a_normal_map(scene)) return found;
  Scene resolved = scene;
  resolve_remap_lists(resolved);
  for (const Instance& instance : resolved.instances) {
    const Mesh& mesh = mesh_of(resolved, instance);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
      if (has_wrong_frame(resolved, mesh, i, mirrors(instance), known))
        found.insert(mesh.triangle_materials[i]);
  }
  return found;
}

namespace {

// The copy of a material for wrong frames, added to the scene when it is not there.
int copy_for_wrong_frames(Scene& scene, int material, std::map<int, int>& copies) {
  const auto [copy, is_new] = copies.try_emplace(material, static_cast<int>(scene.materials.size()));
  if (is_new) {
    Material same = material_at(scene, material);
    same.name += " in wrong frames";
    scene.materials.push_back(std::move(same));
  }
  return copy->second;
}

}  // namespace

Scene with_materials_by_frames(Scene scene, FrameSign known) {
  resolve_remap_lists(scene);
  std::map<int, int> copies;  // of materials
  std::map<std::pair<int, bool>, int> meshes;
  for (Instance& instance : scene.instances) {
    const auto [place, is_new] =
        meshes.try_emplace({instance.mesh, mirrors(instance)}, static_cast<int>(scene.meshes.size()));
    if (is_new) {
      Mesh mesh = mesh_of(scene, instance);
      for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        if (has_wrong_frame(scene, mesh, i, mirrors(instance), known))
          mesh.triangle_materials[i] = copy_for_wrong_frames(scene, mesh.triangle_materials[i], copies);
      mesh.subdivision.reset();
      scene.meshes.push_back(std::move(mesh));
    }
    instance.mesh = place->second;
  }
  return scene;
}

}  // namespace orbs::scene
