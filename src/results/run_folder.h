#pragma once

#include "base/file_lock.h"
#include "results/record.h"

#include <cstddef>
#include <filesystem>
#include <vector>

/// The folder of a run, also while the run goes on. results.json is there from the start, with every render
/// and target still "skipped"; each finished render adds its job.json.

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

/// Held by a run as long as it lives. The system releases it, however the run ends.
class RunLock {
 public:
  /// InputError if another process holds it (the message names it), or if the folder cannot be written to.
  explicit RunLock(const std::filesystem::path& folder);

 private:
  FileLock lock_;
};

/// True while a process holds the lock of the run in `folder`.
bool is_running(const std::filesystem::path& folder);

enum class JobState { Waiting, Running, Done };  // Running: also between two looks

/// Whether another look at the render may follow: it is rendered in looks, and nothing has ended them. Its
/// job.json lies there from the first look on, with preliminary verdicts, and each look replaces it.
inline bool goes_on(const JobRecord& job) {
  return has_image(job) && job.sampling.looks > 0 && job.sampling.end.empty();
}

struct RunView {
  RunRecord run;
  std::vector<JobState> states;  // of run.jobs
  bool is_live = false;          // the run goes on
};

/// Reads the present state of the run. InputError if results.json is missing or broken; a render whose
/// job.json is broken counts as waiting.
RunView read_run_folder(const std::filesystem::path& folder);

/// Updates `view` from its folder. True if it changed.
bool refresh(RunView& view);

}  // namespace orbs::results
