#pragma once

#include "scene/scene.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace orbs::adapters::povray {

/// A mesh as POV-Ray can hold it: its triangles with the remap list applied, split where a material needs a
/// separate object. `material` is -1 for the mesh of all plain materials, else the one mirror or glass.
struct DeclaredMesh {
  std::string name;
  int material = -1;
};

/// Meshes that have been written, so that instances with the same mesh and the same materials share one.
struct MeshLibrary {
  std::string text;  // all #declare mesh2 so far
  std::map<std::pair<int, std::vector<int>>, std::vector<DeclaredMesh>> parts;
};

/// The meshes of the instance with its remap list applied, declared in the library when they are new.
const std::vector<DeclaredMesh>& declared_meshes(const scene::Scene& scene,
                                                 const scene::Instance& instance,
                                                 MeshLibrary& library);

}  // namespace orbs::adapters::povray
