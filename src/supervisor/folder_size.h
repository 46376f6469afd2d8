#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <system_error>

namespace orbs::supervisor {

/// Bytes of all regular files in the folder and the folders in it; symbolic links are not followed. Files
/// that disappear meanwhile count nothing. More than 200 folders within each other count as more than any
/// limit.
inline std::size_t folder_size(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  // The iterator holds a descriptor for each level and would end early where there are no more of them.
  constexpr int kDeepest = 200;
  std::size_t bytes = 0;
  std::error_code failed;
  for (auto entry =
           fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied, failed);
       !failed && entry != fs::recursive_directory_iterator(); entry.increment(failed)) {
    if (entry.depth() > kDeepest) return std::numeric_limits<std::size_t>::max();
    std::error_code gone;
    if (!entry->is_symlink(gone) && entry->is_regular_file(gone))
      if (const auto size = entry->file_size(gone); !gone) bytes += size;
  }
  return bytes;
}

}  // namespace orbs::supervisor
