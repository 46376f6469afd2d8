#include "adapters/material_meshes.h"

#include "scene/lower/geometry.h"
#include "scene/lower/material.h"

#include <utility>

namespace orbs::adapters {

namespace {

// They are invisible, and an emitter must not be sampled there.
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

std::vector<MaterialMesh> material_meshes(const scene::Scene& scene) {
  scene::Scene split = scene;
  scene::bake_texture_matrices(split);
  scene::split_by_material(split);
  std::vector<MaterialMesh> meshes(split.meshes.size());
  for (const scene::Instance& instance : split.instances)
    meshes[static_cast<std::size_t>(instance.mesh)].places.push_back(instance.matrix);
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    meshes[i].mesh = std::move(split.meshes[i]);
    if (!meshes[i].mesh.triangle_materials.empty()) meshes[i].material = meshes[i].mesh.triangle_materials[0];
    drop_triangles_without_area(meshes[i].mesh);
  }
  std::erase_if(meshes,
                [](const MaterialMesh& one) { return one.places.empty() || one.mesh.triangles.empty(); });
  return meshes;
}

}  // namespace orbs::adapters
