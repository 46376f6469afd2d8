#pragma once

#include <filesystem>
#include <string>

namespace orbs {

/// A folder of its own for unfinished files, below the system's temporary folder; gone with the object.
class ScratchFolder {
 public:
  /// `name` tells people whose it is. Throws std::filesystem::filesystem_error when it cannot be made.
  explicit ScratchFolder(const std::string& name);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace orbs
