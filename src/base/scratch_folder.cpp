#include "base/scratch_folder.h"

#include "base/files.h"

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

ScratchFolder::~ScratchFolder() { remove_tree(path_); }

}  // namespace orbs
