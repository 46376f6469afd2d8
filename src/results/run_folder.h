#pragma once

#include "base/file_lock.h"
#include "results/record.h"

#include <cstddef>
#include <filesystem>
#include <vector>

/// The folder of a run as others see it while the run goes on: results.json stands there from the start, with
/// every render and image still "skipped", and each finished render adds its job.json.
namespace orbs::results {

/// Held by a run for as long as it lives; the system lets go of it however the run ends.
class RunLock {
 public:
  /// InputError when another process holds it, which is named, or the folder cannot be written to.
  explicit RunLock(const std::filesystem::path& folder);

 private:
  FileLock lock_;
};

/// True while a process holds the lock of the run in `folder`.
bool is_running(const std::filesystem::path& folder);

enum class JobState { Waiting, Running, Done };

struct RunView {
  RunRecord run;
  std::vector<JobState> states;  // of run.jobs
  bool is_live = false;          // the run goes on
};

/// The run as its folder shows it now. InputError when there is no results.json or it is broken; a job.json
/// that is broken leaves its render waiting.
RunView read_run_folder(const std::filesystem::path& folder);

/// Brings `view` up to date with its folder; true when it changed.
bool refresh(RunView& view);

}  // namespace orbs::results
