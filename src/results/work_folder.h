#pragma once

#include <filesystem>

namespace orbs::results {

/// The folder of unfinished renders: .unfinished/<process id> in the run's folder, removed with the object.
/// No renderer can have this name, because names of renderers never begin with a dot.
class WorkFolder {
 public:
  /// Removes what earlier, killed runs left. The caller holds the run's lock. WriteError if the folder cannot
  /// be made.
  explicit WorkFolder(const std::filesystem::path& run);
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// True if the render in `folder`, relative to the run's, is in progress, or was when the run was killed.
bool is_unfinished(const std::filesystem::path& run, const std::filesystem::path& folder);

}  // namespace orbs::results
