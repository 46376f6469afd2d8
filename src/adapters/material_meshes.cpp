#include "adapters/material_meshes.h"

#include "base/nth.h"
#include "scene/geometry/uv_frames.h"
#include "scene/lower/geometry.h"
#include "scene/lower/lower.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace orbs::adapters {

namespace {

using Corner = std::array<long, 3>;

std::vector<Corner> welded_corners(const scene::Mesh& mesh) {
  double size = 0;
  for (const Vec3f p : mesh.positions)
    size = std::max({size, std::abs(double{p.x}), std::abs(double{p.y}), std::abs(double{p.z})});
  const double cells_per_m = size > 0 ? 1e6 / size : 1;
  std::vector<Corner> corners;
  for (const Vec3f p : mesh.positions)
    corners.push_back({std::lround(double{p.x} * cells_per_m), std::lround(double{p.y} * cells_per_m),
                       std::lround(double{p.z} * cells_per_m)});
  return corners;
}

std::array<Vec3d, 3> corners_of(const scene::Mesh& mesh, std::size_t triangle) {
  const auto& t = mesh.triangles[triangle];
  return {cast<double>(mesh.positions[t[0]]), cast<double>(mesh.positions[t[1]]),
          cast<double>(mesh.positions[t[2]])};
}

}  // namespace

bool is_closed(const scene::Mesh& mesh) {
  const std::vector<Corner> corners = welded_corners(mesh);
  std::map<std::pair<Corner, Corner>, int> surplus;  // of the direction from the smaller corner
  for (const auto& triangle : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Corner& from = corners[triangle[i]];
      const Corner& to = corners[triangle[(i + 1) % 3]];
      if (from < to) ++surplus[{from, to}];
      if (to < from) --surplus[{to, from}];
    }
  return !mesh.triangles.empty() &&
         std::all_of(surplus.begin(), surplus.end(), [](const auto& edge) { return edge.second == 0; });
}

bool is_wound_outwards(const scene::Mesh& mesh) {
  double six_volumes = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = corners_of(mesh, i);
    six_volumes += dot(a, cross(b, c));
  }
  return six_volumes > 0;
}

// Sum of the triangles' signed solid angles (Van Oosterom and Strackee 1983, eq. 8): 4 pi inside, 0 outside.
bool encloses(const scene::Mesh& mesh, Vec3d point) {
  double solid_angle = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    auto [a, b, c] = corners_of(mesh, i);
    a = a - point;
    b = b - point;
    c = c - point;
    const double la = length(a);
    const double lb = length(b);
    const double lc = length(c);
    solid_angle +=
        2 * std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(a, c) * lb + dot(b, c) * la);
  }
  return std::abs(solid_angle) > 2 * std::numbers::pi;
}

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

namespace {

// The parts of a blend included. What turns with the coordinates u and v turns with the first ones.
std::set<int> uv_sets_of(const scene::Scene& scene, int index) {
  const scene::Material& material = material_at(scene, index);
  std::set<int> sets;
  for (const scene::TextureUse& use : shown_texture_uses(scene.materials, index)) sets.insert(use.uv_set);
  if (std::holds_alternative<scene::AnisotropicGgx>(material.model)) sets.insert(0);
  if (const auto* blend = std::get_if<scene::Blend>(&material.model))
    for (const auto& part : blend->parts)
      if (std::holds_alternative<scene::AnisotropicGgx>(material_at(scene, part.material).model))
        sets.insert(0);
  return sets;
}

}  // namespace

std::string uv_set_limit(const scene::Scene& scene, int material, const char* renderer) {
  if (uv_sets_of(scene, material).size() < 2) return "";
  return fmt::format("material '{}' looks textures up at both sets of texture coordinates: {} has one",
                     material_at(scene, material).name, renderer);
}

std::vector<MaterialMesh> material_meshes(const scene::Scene& scene, UvSets uv_sets) {
  scene::Scene split = scene;
  scene::bake_texture_matrices(split);
  scene::split_by_material(split);
  std::vector<MaterialMesh> meshes(split.meshes.size());
  for (const scene::Instance& instance : split.instances)
    nth(meshes, instance.mesh).places.push_back(instance.matrix);
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    meshes[i].mesh = std::move(split.meshes[i]);
    if (!meshes[i].mesh.triangle_materials.empty()) meshes[i].material = meshes[i].mesh.triangle_materials[0];
    scene::Mesh& mesh = meshes[i].mesh;
    if (uv_sets == UvSets::One) {
      if (uv_sets_of(scene, meshes[i].material) == std::set{1}) mesh.uvs = mesh.second_uvs;
      mesh.second_uvs.clear();
    }
    drop_triangles_without_area(mesh);
  }
  std::erase_if(meshes,
                [](const MaterialMesh& one) { return one.places.empty() || one.mesh.triangles.empty(); });
  return meshes;
}

namespace {

scene::Mesh with_triangles(const scene::Mesh& mesh, bool is_mirrored) {
  scene::Mesh part = mesh;
  part.triangles.clear();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto frame = scene::uv_frame(mesh, i);
    if ((frame && scene::is_mirrored(*frame)) == is_mirrored) part.triangles.push_back(mesh.triangles[i]);
  }
  part.triangle_materials.resize(part.triangles.size());
  return part;
}

}  // namespace

std::vector<MaterialMesh> split_by_frames(const scene::Scene& scene,
                                          const std::vector<MaterialMesh>& meshes) {
  std::vector<MaterialMesh> out;
  for (const MaterialMesh& given : meshes) {
    if (!material_at(scene, given.material).detail.normal_map) {
      out.push_back(given);
      continue;
    }
    for (const bool by_uvs : {false, true}) {
      const scene::Mesh mesh = with_triangles(given.mesh, by_uvs);
      if (mesh.triangles.empty()) continue;
      for (const bool by_matrix : {false, true}) {
        MaterialMesh part{mesh, given.material, {}, by_uvs != by_matrix};
        for (const Mat4& place : given.places)
          if ((determinant3(place) < 0) == by_matrix) part.places.push_back(place);
        if (!part.places.empty()) out.push_back(std::move(part));
      }
    }
  }
  return out;
}

}  // namespace orbs::adapters
