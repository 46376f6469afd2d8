#include "base/scratch_folder.h"

#include <cerrno>
#include <cstdlib>
#include <system_error>

namespace orbs {

ScratchFolder::ScratchFolder(const std::string& name) {
  auto pattern = (std::filesystem::temp_directory_path() / (name + "-XXXXXX")).string();
  if (::mkdtemp(pattern.data()) == nullptr)
    throw std::filesystem::filesystem_error("cannot make a scratch folder", pattern,
                                            std::error_code(errno, std::generic_category()));
  path_ = pattern;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace orbs
