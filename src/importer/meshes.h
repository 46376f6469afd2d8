#pragma once

#include "importer/import.h"
#include "importer/surface_map.h"
#include "importer/vertices.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace orbs::importer {

/// Adds meshes to the scene.
class Meshes {
 public:
  explicit Meshes(Import& import) : import_(&import) {}

  /// The index of the scene's mesh for that of glTF, all primitives in one; nothing if none has triangles.
  std::optional<int> add(int index, const Pose& pose);

 private:
  void add_primitive(const tinygltf::Primitive& primitive,
                     const std::string& where,
                     const Pose& pose,
                     scene::Mesh& mesh);
  void add_materials(const tinygltf::Primitive& primitive,
                     const std::string& where,
                     const std::vector<Vec2f>& map_uvs,
                     scene::Mesh& mesh);
  const std::optional<SurfaceMap>& surface_map(int material);

  Import* import_;
  UniqueNames names_;
  std::map<int, std::optional<int>> resting_;  // meshes that no skin moves and no target changes
  std::map<int, std::optional<SurfaceMap>> surface_maps_;
  std::size_t triangles_left_ = std::size_t{1} << 26;  // as of a scene file
};

}  // namespace orbs::importer
