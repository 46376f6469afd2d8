#include "scene/lower/geometry.h"

#include "base/nth.h"
#include "scene/geometry/generators.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

// Copies the triangles of one material, with only the vertices that they use, in their old order.
Mesh submesh_of(const Mesh& mesh, int material) {
  constexpr std::uint32_t kUnused = 0xffffffff;
  std::vector<std::uint32_t> place(mesh.positions.size(), kUnused);
  Mesh part;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (mesh.triangle_materials[i] == material) {
      part.triangles.push_back(mesh.triangles[i]);
      for (const auto vertex : mesh.triangles[i]) place[vertex] = 0;
    }
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (place[i] == kUnused) continue;
    place[i] = static_cast<std::uint32_t>(part.positions.size());
    append_vertex(part, mesh, i);
  }
  for (auto& triangle : part.triangles)
    for (auto& vertex : triangle) vertex = place[vertex];
  part.triangle_materials.assign(part.triangles.size(), material);
  return part;
}

std::set<int> materials_of(const Mesh& mesh) {
  return {mesh.triangle_materials.begin(), mesh.triangle_materials.end()};
}

// Adds a world-space copy of a mesh to `world`. A mirroring matrix reverses the winding, so it is reversed
// again: winding and vertex normals keep their relation, and all triangles of the scene one order (REQ_G1).
void append_transformed(Mesh& world, const Mesh& mesh, const Instance& instance) {
  const auto first = static_cast<std::uint32_t>(world.positions.size());
  const Mat4 to_local = inverse(instance.matrix).value();  // the loader lets only invertible matrices through
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    world.positions.push_back(cast<float>(transform_point(instance.matrix, cast<double>(mesh.positions[i]))));
    world.normals.push_back(
        cast<float>(normalised(transform_normal(to_local, cast<double>(mesh.normals[i])))));
    world.tangents.push_back(
        cast<float>(transform_direction(instance.matrix, cast<double>(mesh.tangents[i]))));
    world.uvs.push_back(mesh.uvs[i]);
  }
  append_second_uvs(world, mesh, first, world.positions.size());
  const bool mirrored = determinant3(instance.matrix) < 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    auto [a, b, c] = mesh.triangles[i];
    if (mirrored) std::swap(b, c);
    world.triangles.push_back({first + a, first + b, first + c});
    world.triangle_materials.push_back(remapped(instance, mesh.triangle_materials[i]));
  }
}

}  // namespace

void resolve_remap_lists(Scene& scene) {
  std::map<std::pair<int, std::vector<int>>, int> copies;  // (mesh, materials of its triangles) -> mesh
  const auto original_count = scene.meshes.size();
  for (std::size_t i = 0; i < original_count; ++i)
    copies[{static_cast<int>(i), scene.meshes[i].triangle_materials}] = static_cast<int>(i);
  for (auto& instance : scene.instances) {
    if (instance.remap.empty()) continue;
    auto materials = mesh_of(scene, instance).triangle_materials;
    for (auto& material : materials) material = remapped(instance, material);
    const auto [copy, is_new] =
        copies.try_emplace({instance.mesh, materials}, static_cast<int>(scene.meshes.size()));
    if (is_new) {
      Mesh mesh = mesh_of(scene, instance);
      mesh.name = fmt::format("{}#{}", mesh.name, scene.meshes.size());
      mesh.triangle_materials = std::move(materials);
      scene.meshes.push_back(std::move(mesh));
    }
    instance.mesh = copy->second;
    instance.remap.clear();
  }
}

void split_by_material(Scene& scene) {
  resolve_remap_lists(scene);
  std::vector<Mesh> parts;
  std::vector<std::vector<int>> parts_of_mesh(scene.meshes.size());
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const auto materials = materials_of(scene.meshes[i]);
    for (const int material : materials) {
      parts_of_mesh[i].push_back(static_cast<int>(parts.size()));
      parts.push_back(materials.size() == 1 ? scene.meshes[i] : submesh_of(scene.meshes[i], material));
      parts.back().name = scene.meshes[i].name;
      if (materials.size() > 1) parts.back().name += fmt::format("#m{}", material);
    }
  }
  std::vector<Instance> instances;
  for (const auto& instance : scene.instances)
    for (const int part : nth(parts_of_mesh, instance.mesh)) {
      instances.push_back(instance);
      instances.back().mesh = part;
    }
  scene.meshes = std::move(parts);
  scene.instances = std::move(instances);
}

void merge_into_world_mesh(Scene& scene) {
  Mesh world;
  world.name = "world";
  for (const auto& instance : scene.instances) append_transformed(world, mesh_of(scene, instance), instance);
  scene.meshes.clear();
  scene.instances.clear();
  if (world.triangles.empty()) return;
  scene.meshes.push_back(std::move(world));
  scene.instances.push_back({"world", 0, Mat4{}, {}});
}

void tessellate_spheres(Scene& scene) {
  std::map<int, int> mesh_of;  // by material
  for (const auto& sphere : scene.spheres) {
    const auto [mesh, is_new] = mesh_of.try_emplace(sphere.material, static_cast<int>(scene.meshes.size()));
    if (is_new) {
      scene.meshes.push_back(tessellated(SphereForm{{}, 1}).value());
      scene.meshes.back().name = fmt::format("sphere of material {}", sphere.material);
      scene.meshes.back().triangle_materials.assign(scene.meshes.back().triangles.size(), sphere.material);
    }
    const double r = sphere.radius_m;
    scene.instances.push_back(
        {sphere.name, mesh->second, translation(sphere.centre_m) * scaling({r, r, r}), {}});
  }
  scene.spheres.clear();
}

void tessellate_shapes(Scene& scene, const char* level) {
  std::vector<Shape> kept;
  for (Shape& shape : scene.shapes) {
    auto mesh = level_of(shape.form) == std::string_view(level) ? tessellated(shape.form) : std::nullopt;
    if (!mesh) {
      kept.push_back(std::move(shape));
      continue;
    }
    mesh->name = fmt::format("shape {} as triangles", scene.meshes.size());
    mesh->triangle_materials.assign(mesh->triangles.size(), shape.material);
    scene.instances.push_back({shape.name, static_cast<int>(scene.meshes.size()), shape.matrix, {}});
    scene.meshes.push_back(std::move(*mesh));
  }
  scene.shapes = std::move(kept);
}

}  // namespace orbs::scene
