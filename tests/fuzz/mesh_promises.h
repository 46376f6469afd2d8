#pragma once

#include "fuzz/feed.h"
#include "scene/geometry/mesh_file.h"
#include "scene/load/mesh.h"

namespace orbs::fuzz {

/// What the scene's reader relies on in a mesh that a file gave.
inline void check_mesh_file(const scene::MeshFile& file) {
  const auto& mesh = file.mesh;
  require(!mesh.triangles.empty(), "a mesh has triangles");
  require(mesh.triangle_materials.size() == mesh.triangles.size(), "each triangle has a material");
  for (const int material : mesh.triangle_materials)
    require(file.names_are_slots || material < static_cast<int>(file.material_names.size()),
            "each material of a triangle has a name");
  scene::mesh_problem(mesh);  // looks at all of it
}

}  // namespace orbs::fuzz
