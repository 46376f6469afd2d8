#include "results/run_folder.h"

#include "base/error.h"
#include "base/text.h"
#include "results/read_record.h"
#include "results/work_folder.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace orbs::results {

namespace fs = std::filesystem;

namespace {

constexpr const char* kLockFile = "run.lock";

// Takes over what the job's own file says; false when there is nothing to take, or nothing readable.
bool take_job_file(RunView& view, std::size_t index) {
  auto& job = view.run.jobs[index];
  const auto file = fs::path(view.run.folder) / job.folder / "job.json";
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return false;
  JobFile found;
  try {
    found = read_job_file(file);
  } catch (const InputError&) {
    return false;  // results.json will say what became of it
  }
  if (found.job.id != job.id) return false;
  job = std::move(found.job);
  for (auto& picture : found.pictures)
    for (auto& known : view.run.pictures)
      if (known.case_name == picture.case_name && known.picture == picture.picture &&
          known.renderer == picture.renderer)
        known = picture;
  return true;
}

bool update_jobs(RunView& view) {
  bool changed = false;
  for (std::size_t i = 0; i < view.run.jobs.size(); ++i) {
    if (view.states[i] == JobState::Done) continue;
    auto state = view.states[i];
    if (take_job_file(view, i)) {
      state = JobState::Done;
    } else if (is_unfinished(view.run.folder, view.run.jobs[i].folder)) {
      state = JobState::Running;
    }
    changed = changed || state != view.states[i];
    view.states[i] = state;
  }
  return changed;
}

// The file may have been removed by its last holder between our opening and our locking it.
bool is_file(int descriptor, const fs::path& file) {
  struct stat ours {};
  struct stat there {};
  return ::fstat(descriptor, &ours) == 0 && ::stat(file.c_str(), &there) == 0 && ours.st_ino == there.st_ino;
}

[[noreturn]] void refuse_locked(const fs::path& file, int descriptor, int error) {
  std::array<char, 32> holder{};
  const auto length = descriptor < 0 ? 0 : ::pread(descriptor, holder.data(), holder.size(), 0);
  if (descriptor >= 0) ::close(descriptor);
  if (descriptor < 0 || (error != EAGAIN && error != EACCES))
    throw InputError(fmt::format("{}: cannot be locked: {}", file.string(), std::strerror(error)));
  throw InputError(fmt::format(
      "{}: a run of process {} goes on in this folder; wait for its end, or stop it",
      file.parent_path().string(),
      trim(std::string_view(holder.data(), static_cast<std::size_t>(std::max<ssize_t>(length, 0))))));
}

// Of the open file, not of the process, so that one process, too, cannot lock it twice; and unlike that of
// flock(2) it can be asked for without being taken, which would be in the way of a run that begins.
struct flock whole_file() {
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  return lock;
}

}  // namespace

RunLock::RunLock(const fs::path& folder) : file_(folder / kLockFile) {
  for (;;) {
    descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    const auto lock = whole_file();
    if (descriptor_ < 0 || ::fcntl(descriptor_, F_OFD_SETLK, &lock) != 0)
      refuse_locked(file_, descriptor_, errno);
    if (is_file(descriptor_, file_)) break;
    ::close(descriptor_);
  }
  const auto holder = fmt::format("{}\n", ::getpid());
  if (::ftruncate(descriptor_, 0) != 0 || ::write(descriptor_, holder.data(), holder.size()) < 0)
    refuse_locked(file_, descriptor_, errno);
}

RunLock::~RunLock() {
  std::error_code ignored;
  fs::remove(file_, ignored);
  ::close(descriptor_);
}

bool is_running(const fs::path& folder) {
  const int descriptor = ::open((folder / kLockFile).c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (descriptor < 0) return false;
  auto lock = whole_file();
  const bool taken = ::fcntl(descriptor, F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
  ::close(descriptor);
  return taken;
}

RunView read_run_folder(const fs::path& folder) {
  RunView view;
  const auto file = folder / "results.json";
  std::error_code ignored;
  if (!fs::exists(file, ignored))
    throw InputError(fmt::format(
        "{}: holds no results.json, so it is not the folder of a run; name one that 'orbs run' made",
        folder.string()));
  // Asked before the file is read: a run that ends in between is read once more, not taken for a dead one.
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
