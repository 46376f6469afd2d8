#pragma once

#include <filesystem>

namespace orbs::results {

/// Where renders of a run lie until they are whole: .unfinished/<process id> in the run's folder, gone with
/// the object. Names of renderers never begin with a point, so nothing else is called so.
class WorkFolder {
 public:
  /// Clears away what earlier, killed runs left. The caller holds the run's lock. WriteError when it cannot
  /// be made.
  explicit WorkFolder(const std::filesystem::path& run);
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Whether the render in `folder`, relative to the run's, is being worked on or was when the run was killed.
bool is_unfinished(const std::filesystem::path& run, const std::filesystem::path& folder);

}  // namespace orbs::results
