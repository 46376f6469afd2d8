#pragma once

#include "importer/report.h"
#include "importer/source.h"
#include "scene/scene.h"

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>

namespace orbs::importer {

/// The names of one list of a scene file, each of which must be another.
class UniqueNames {
 public:
  /// `wanted`, or with a number behind it; `otherwise` if it is "".
  std::string add(const std::string& wanted, const std::string& otherwise);

 private:
  std::set<std::string> taken_;
  std::map<std::string, int> counts_;
};

/// What a material is multiplied by where it is shown: the mean colour of the vertices there, and what the
/// texture of metal and roughness says there.
struct Shown {
  scene::RgbColour tint{1, 1, 1};
  double metallic = 1;
  double roughness = 1;
};

/// An import under way.
struct Import {
  const Source& source;
  Report& report;
  std::filesystem::path folder;  // that the textures are written to
  scene::Scene scene{};
  UniqueNames material_names{};
  std::map<std::array<double, 6>, int> materials{};  // by glTF's index and Shown
  /// By glTF's image and sampler, and what was made of them: "colours", "numbers", "alpha".
  std::map<std::tuple<int, int, std::string>, int> textures{};
};

}  // namespace orbs::importer
