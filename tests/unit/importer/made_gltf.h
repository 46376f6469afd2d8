#pragma once

#include "base/files.h"
#include "importer/import_scene.h"

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

/// Files of glTF that tests make, from the specification.
namespace orbs::importer_tests {

struct MadeGltf {
  nlohmann::json json{{"asset", {{"version", "2.0"}}}};
  std::string buffer;

  /// Each returns the index of what it adds.
  int add_view(const std::string& bytes);
  int add_floats(const std::vector<float>& numbers, const std::string& type);
  int add_indices(const std::vector<std::uint16_t>& indices);
  /// A PNG of one row, with these colours of 8 bits.
  int add_image(const std::vector<std::array<int, 3>>& texels);
  int add(const char* list, const nlohmann::json& entry);

  /// The bytes of a .glb file.
  std::string glb() const;
};

/// One triangle in the plane z = 0 that looks at +Z, with texture coordinates, in a mesh with the material 0
/// in the one node of the one scene.
MadeGltf triangle();

/// The triangle with that material, and an image of two texels as the texture 0.
MadeGltf with_material(const nlohmann::json& material);

struct Imported {
  scene::Scene scene;
  importer::Report report;
  /// Whether a remark begins with that.
  bool names(const std::string& what) const;
};

/// A folder with imports.
class ImportFolder {
 public:
  Imported import(const MadeGltf& made, const importer::View& view = {}) const;
  /// The message of an import that fails; the test fails if it does not.
  std::string refusal(const std::string& bytes, const std::string& name = "scene.glb") const;
  std::string refusal(const MadeGltf& made) const { return refusal(made.glb()); }
  const std::filesystem::path& path() const { return scratch_.path(); }

 private:
  ScratchFolder scratch_{"orbs-importer"};
};

}  // namespace orbs::importer_tests
