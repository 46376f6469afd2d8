#pragma once

#include <filesystem>
#include <vector>

namespace orbs::adapters {

/// What lies in a folder of programs and would tell a renderer what its image should be.
struct PrivateParts {
  std::vector<std::filesystem::path> folders;  // repositories of version control, runs, references
  std::vector<std::filesystem::path> files;    // cases, and images that say who made them, among others
};

/// Those at and below `folder`, absolute; no link is followed. References, and copies of them, are known by
/// the attributes "orbs.…" of an EXR file. What was found once is not searched again.
const PrivateParts& private_parts(const std::filesystem::path& folder);

}  // namespace orbs::adapters
