#pragma once

#include "adapters/obj/world_parts.h"
#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

/// What files of meshes cannot say of a scene, as JSON for people and for programs that people write: camera,
/// lamps, materials, background and trace depth, with words beside the numbers.
namespace orbs::adapters::obj {

/// Where a part's triangles are: a key of the description with the file or the object that holds them.
struct PartPlace {
  const char* key = "";
  std::string name;
  int material = 0;
};

constexpr const char* kDescriptionFile = "description.json";

/// Writes description.json into the folder, and beside it the textures that the materials name and the IES
/// profiles of the lamps. `stem` is that of the scene file, by which they are called. InputError when a file
/// cannot be read or written.
void write_description(const scene::Scene& scene,
                       const std::vector<PartPlace>& parts,
                       const std::string& stem,
                       const std::filesystem::path& folder);

}  // namespace orbs::adapters::obj
