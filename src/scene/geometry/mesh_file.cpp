#include "scene/geometry/mesh_file.h"

#include "scene/geometry/placed_vertices.h"

#include <utility>

namespace orbs::scene {

void place_vertices(const std::vector<Vec3d>& vertices, MeshFile& file) {
  auto placed = placed_vertices(vertices);
  file.mesh.positions = std::move(placed.positions);
  file.origin_m = placed.origin_m;
}

}  // namespace orbs::scene
