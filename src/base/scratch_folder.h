#pragma once

#include <filesystem>
#include <string>

namespace orbs {

/// A new folder for unfinished files in the system's temporary folder. It is deleted with the object.
class ScratchFolder {
 public:
  /// `name` tells users who made it. Throws std::filesystem::filesystem_error if it cannot be made.
  explicit ScratchFolder(const std::string& name);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace orbs
