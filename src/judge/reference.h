#pragma once

#include "image/image.h"
#include "registry/case.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace orbs::judge {

/// The reference of a target: an image file, or the difference of two.
struct Reference {
  std::filesystem::path file;         // of the scene, or of the difference's `of`
  std::optional<image::Image> image;  // nothing when it is missing
  std::string problem;                // why it is missing
};

/// Reads the reference of a target of the case from the folder `references`. A reference is stale, and so
/// missing, if the scene hash or its own pixel hash differs from its provenance record. `scene_hashes` holds
/// by scene today's hash; a scene that is not in it is not checked.
Reference load_reference(const registry::Case& one_case,
                         const std::string& target,
                         const std::filesystem::path& references,
                         const std::map<std::string, std::string>& scene_hashes = {});

/// The files that the reference of a target is made from: one, or the two of a difference.
std::vector<std::filesystem::path> reference_files(const registry::Case& one_case,
                                                   const std::string& target,
                                                   const std::filesystem::path& references);

/// Puts the reference of each target of the cases for which load_reference finds one into `folder` as
/// <target>.exr: files of scenes unchanged, differences computed. With them the folder of a run can be looked
/// at on its own.
void copy_references(const std::vector<registry::Case>& cases,
                     const std::filesystem::path& references,
                     const std::map<std::string, std::string>& scene_hashes,
                     const std::filesystem::path& folder);

}  // namespace orbs::judge
