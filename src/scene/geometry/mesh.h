#pragma once

#include "base/vec.h"
#include "scene/geometry/subdivision/subdivision_surface.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace orbs::scene {

/// The vertices of a mesh at the end of the frame. See scene/motion.h for the times between.
struct MeshEnd {
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;
  bool operator==(const MeshEnd&) const = default;
};

/// Indexed triangles with the attributes of ORB.S REQ_G1, used exactly as given. All vertex arrays have one
/// length; there need be no second texture coordinates.
struct Mesh {
  std::string name;
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;
  std::vector<Vec3f> tangents;      // zero where not available
  std::vector<Vec2f> uvs;           // zero where not available
  std::vector<Vec2f> second_uvs{};  // empty where not available
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<int> triangle_materials;  // one per triangle
  /// What the triangles, all of one material, are made from; who changes triangles or vertices drops it.
  std::optional<SubdivisionSurface> subdivision = std::nullopt;
  /// Of a mesh that changes its shape within the frame; `positions` and `normals` are those of its start.
  std::optional<MeshEnd> end = std::nullopt;
  bool operator==(const Mesh&) const = default;
};

inline std::uint32_t vertex_count(const Mesh& mesh) {
  return static_cast<std::uint32_t>(mesh.positions.size());
}

/// Whether a normal can be used as given.
inline bool is_direction(Vec3f normal) { return is_finite(normal) && dot(normal, normal) != 0; }

/// Appends a vertex with tangent zero and returns its index.
inline std::uint32_t add_vertex(Mesh& mesh, Vec3d position, Vec3d normal, Vec2d uv) {
  mesh.positions.push_back(cast<float>(position));
  mesh.normals.push_back(cast<float>(normal));
  mesh.tangents.push_back({});
  mesh.uvs.push_back({static_cast<float>(uv.x), static_cast<float>(uv.y)});
  return vertex_count(mesh) - 1;
}

/// Appends vertex `index` of `from`, of both times if it has two.
inline void append_vertex(Mesh& mesh, const Mesh& from, std::size_t index) {
  mesh.positions.push_back(from.positions[index]);
  mesh.normals.push_back(from.normals[index]);
  mesh.tangents.push_back(from.tangents[index]);
  mesh.uvs.push_back(from.uvs[index]);
  if (!from.second_uvs.empty()) mesh.second_uvs.push_back(from.second_uvs[index]);
  if (!from.end) return;
  if (!mesh.end) mesh.end.emplace();
  mesh.end->positions.push_back(from.end->positions[index]);
  mesh.end->normals.push_back(from.end->normals[index]);
}

/// Appends the second coordinates of the vertices that were just appended from `from`; they are zero where
/// one of the meshes has none.
inline void append_second_uvs(Mesh& mesh,
                              const Mesh& from,
                              std::size_t vertices_before,
                              std::size_t vertices) {
  if (mesh.second_uvs.empty() && from.second_uvs.empty()) return;
  mesh.second_uvs.resize(vertices_before);
  mesh.second_uvs.insert(mesh.second_uvs.end(), from.second_uvs.begin(), from.second_uvs.end());
  mesh.second_uvs.resize(vertices);
}

/// Two triangles for each cell of a grid of (rows + 1)(columns + 1) vertices stored row by row from index
/// `first`, row after row. Counter-clockwise when seen against (along the rows' index) x (along the columns'
/// index).
inline void add_grid_triangles(Mesh& mesh, std::uint32_t first, int rows, int columns) {
  const auto stride = static_cast<std::uint32_t>(columns) + 1;
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(rows); ++i)
    for (std::uint32_t j = 0; j + 1 < stride; ++j) {
      const std::uint32_t corner = first + i * stride + j;
      mesh.triangles.push_back({corner, corner + stride, corner + stride + 1});
      mesh.triangles.push_back({corner, corner + stride + 1, corner + 1});
    }
}

}  // namespace orbs::scene
