#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

namespace orbs::scene {

/// A mesh as a file holds it: its materials are still names of the file.
struct MeshFile {
  Mesh mesh;  // triangle_materials index into material_names
  std::vector<std::string> material_names;
  bool names_are_slots = false;  // PLY: the materials are indices into a list outside of the file
  bool lacks_normals = false;    // then they are zero
};

/// Whether a file must have normals, or may leave them to be computed.
enum class FileNormals { Required, MayLack };

}  // namespace orbs::scene
