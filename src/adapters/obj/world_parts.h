#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

/// A scene for programs that know neither instances nor matrices.
namespace orbs::adapters::obj {

/// Triangles of one material, in world space: one placement of a mesh, or of the part of it that shows the
/// material. Winding and vertex normals keep their relation, also under a mirroring matrix.
struct WorldPart {
  std::string name;
  int material = 0;
  scene::Mesh mesh;
};

/// All that is visible of the meshes, with remap lists resolved and texture matrices applied to the
/// coordinates.
std::vector<WorldPart> world_parts(const scene::Scene& scene);

/// The names as OBJ, MTL and file systems take them: letters, digits, '-' and '_', each one once and in place
/// of the name at the same index.
std::vector<std::string> plain_names(const std::vector<std::string>& names);

/// plain_names of the materials.
std::vector<std::string> material_names(const scene::Scene& scene);

}  // namespace orbs::adapters::obj
