#include "results/run_folder.h"

#include "base/error.h"
#include "base/files.h"
#include "results/record.h"

#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

namespace orbs::results {

namespace fs = std::filesystem;

namespace {

constexpr const char* kUnfinished = ".unfinished";

}  // namespace

// The process id keeps it apart from renders of a killed run that are just being ended by their supervisors.
WorkFolder::WorkFolder(const fs::path& run) : path_(run / kUnfinished / fmt::format("{}", ::getpid())) {
  remove_tree(run / kUnfinished);
  make_folder(path_);
}

WorkFolder::~WorkFolder() { remove_tree(path_.parent_path()); }

bool is_unfinished(const fs::path& run, const fs::path& folder) {
  std::error_code failed;
  for (auto entry = fs::directory_iterator(run / kUnfinished, failed);
       !failed && entry != fs::directory_iterator(); entry.increment(failed))
    if (std::error_code ignored; fs::is_directory(entry->path() / folder, ignored)) return true;
  return false;
}

namespace fs = std::filesystem;

namespace {

constexpr const char* kLockFile = "run.lock";

// Takes over the job's own file. False if there is none, or none that can be read.
bool take_job_file(RunView& view, std::size_t index) {
  auto& job = view.run.jobs[index];
  const auto file = fs::path(view.run.folder) / job.files.folder / "job.json";
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return false;
  JobFile found;
  try {
    found = read_job_file(file);
  } catch (const InputError&) {
    return false;  // results.json will hold its outcome when the run ends
  }
  if (found.job.identity.id != job.identity.id) return false;
  job = std::move(found.job);
  for (auto& target : found.targets)
    for (auto& known : view.run.targets)
      if (known.case_name == target.case_name && known.target == target.target &&
          known.renderer == target.renderer)
        known = target;
  return true;
}

bool update_jobs(RunView& view) {
  bool changed = false;
  for (std::size_t i = 0; i < view.run.jobs.size(); ++i) {
    if (view.states[i] == JobState::Done) continue;
    auto state = view.states[i];
    const int looks = view.run.jobs[i].sampling.looks;
    if (take_job_file(view, i)) {
      state = goes_on(view.run.jobs[i]) ? JobState::Running : JobState::Done;
    } else if (is_unfinished(view.run.folder, view.run.jobs[i].files.folder)) {
      state = JobState::Running;
    }
    changed = changed || state != view.states[i] || looks != view.run.jobs[i].sampling.looks;
    view.states[i] = state;
  }
  return changed;
}

}  // namespace

RunLock::RunLock(const fs::path& folder)
    : lock_(folder / kLockFile, [&](const std::string& process) {
        return fmt::format("{}: a run of process {} goes on in this folder; wait for its end, or stop it",
                           folder.string(), process);
      }) {}

bool is_running(const fs::path& folder) { return is_locked(folder / kLockFile); }

RunView read_run_folder(const fs::path& folder) {
  RunView view;
  const auto file = folder / "results.json";
  std::error_code ignored;
  if (!fs::exists(file, ignored))
    throw InputError(fmt::format(
        "{}: holds no results.json, so it is not the folder of a run; name one that 'orbs run' made",
        folder.string()));
  // Checked before the file is read: a run that ends in between must not be taken for a killed one.
  const bool was_running = is_running(folder);
  view.run = read_results_file(file);
  view.is_live = was_running && !view.run.finished;
  view.states.assign(view.run.jobs.size(), view.run.finished ? JobState::Done : JobState::Waiting);
  if (!view.run.finished) update_jobs(view);
  return view;
}

bool refresh(RunView& view) {
  if (!view.is_live) return false;
  if (is_running(view.run.folder)) return update_jobs(view);
  view = read_run_folder(view.run.folder);
  return true;
}

}  // namespace orbs::results
