#include "supervisor/folder_size.h"

#include <system_error>

namespace orbs::supervisor {

std::size_t folder_size(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  std::size_t bytes = 0;
  std::error_code failed;
  for (auto entry =
           fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied, failed);
       !failed && entry != fs::recursive_directory_iterator(); entry.increment(failed)) {
    std::error_code gone;
    if (!entry->is_symlink(gone) && entry->is_regular_file(gone))
      if (const auto size = entry->file_size(gone); !gone) bytes += size;
  }
  return bytes;
}

}  // namespace orbs::supervisor
