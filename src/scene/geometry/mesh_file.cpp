#include "scene/geometry/mesh_file.h"

#include "base/error.h"
#include "scene/geometry/triangulate.h"
#include "scene/geometry/world_bounds.h"

#include <utility>

#include <fmt/format.h>

namespace orbs::scene {

void place_vertices(const std::vector<Vec3d>& vertices, MeshFile& file) {
  auto placed = placed_vertices(vertices);
  file.mesh.positions = std::move(placed.positions);
  file.origin_m = placed.origin_m;
}

namespace {

// Whether the face crosses itself.
bool add_face_triangles(const std::uint32_t* corners, std::uint32_t count, int material, Mesh& mesh) {
  std::vector<Vec3d> places;
  for (std::uint32_t i = 0; i < count; ++i) places.push_back(cast<double>(mesh.positions[corners[i]]));
  const auto made = triangulate(places);
  for (const auto& [a, b, c] : made.triangles) {
    mesh.triangles.push_back({corners[a], corners[b], corners[c]});
    mesh.triangle_materials.push_back(material);
  }
  return made.crosses_itself;
}

}  // namespace

void add_triangles(const Polygons& faces,
                   const std::function<std::string(std::size_t)>& place_of,
                   MeshFile& file) {
  std::size_t crossing = 0;
  std::string first;
  const std::uint32_t* corners = faces.corners.data();
  for (std::size_t i = 0; i < faces.sizes.size(); corners += faces.sizes[i], ++i) {
    try {
      const bool crosses = add_face_triangles(corners, faces.sizes[i], faces.materials[i], file.mesh);
      if (crosses && crossing++ == 0) first = place_of(i);
    } catch (const InputError& e) {
      throw InputError(fmt::format("{}: {}", place_of(i), e.what()));
    }
  }
  if (crossing > 0)
    file.warnings.push_back(
        fmt::format("{}: edges of this face cross, so no triangles cover it once, and it is a fan around its "
                    "first corner; faces of this kind in the file: {}",
                    first, crossing));
}

}  // namespace orbs::scene
