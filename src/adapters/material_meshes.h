#pragma once

#include "scene/scene.h"

#include <vector>

namespace orbs::adapters {

/// A mesh in one material and the places where it stands.
struct MaterialMesh {
  scene::Mesh mesh;  // triangles that have area
  int material = 0;
  std::vector<Mat4> places;  // at least one
};

/// The visible surfaces of a scene for renderers that give one material to a whole mesh and apply no texture
/// matrices: remap lists are resolved, and texture matrices are applied to the coordinates. Instances with
/// the same mesh and materials share a MaterialMesh.
std::vector<MaterialMesh> material_meshes(const scene::Scene& scene);

}  // namespace orbs::adapters
