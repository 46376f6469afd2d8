#pragma once

#include "scene/scene.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace orbs::adapters::povray {

/// One mesh as POV-Ray can hold it: its triangles after remap lists, split where a material needs an object
/// of its own. `material` is -1 for the part with all plain materials, else the one mirror or glass.
struct MeshPart {
  std::string name;
  int material = -1;
};

/// Meshes that have been written, so that instances with the same mesh and the same materials share one.
struct MeshLibrary {
  std::string text;  // all #declare mesh2 so far
  std::map<std::pair<int, std::vector<int>>, std::vector<MeshPart>> parts;
};

/// The parts of the instance's mesh with its remap list applied, declared in the library when they are new.
const std::vector<MeshPart>& mesh_parts(const scene::Scene& scene,
                                        const scene::Instance& instance,
                                        MeshLibrary& library);

}  // namespace orbs::adapters::povray
