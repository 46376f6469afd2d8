#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// The folder of a study of stability as the server and the one-file page see it. The page reads
/// stability.json as it is.
namespace orbs::results {

inline constexpr const char* kStabilityFile = "stability.json";
inline constexpr const char* kStabilityFormat = "orbs-stability/1";

/// What lies in the folder of each step that kept images.
inline constexpr const char* kOriginalImage = "original.png";
inline constexpr const char* kChangedImage = "changed.png";
inline constexpr const char* kDifferenceImage = "difference.png";

struct StabilityFolder {
  std::string started;
  std::vector<std::string> images;  // of all steps, relative to the folder
};

/// True if the folder holds a stability.json.
bool holds_stability_study(const std::filesystem::path& folder);

/// InputError if stability.json is missing, broken, or of another format than "orbs-stability/1".
StabilityFolder read_stability_folder(const std::filesystem::path& folder);

}  // namespace orbs::results
