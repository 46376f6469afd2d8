#include "run/resume.h"

#include "base/error.h"
#include "base/files.h"
#include "image/image_io.h"
#include "run/outdated.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

namespace orbs::run {

namespace {

namespace fs = std::filesystem;
using results::JobFile;
using results::JobOutcome;
using results::JobRecord;

// What an earlier run left of this render; nothing when there is nothing, or nothing whole.
std::optional<JobFile> found_job(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(folder / "job.json", ignored)) return std::nullopt;
  try {
    return results::read_job_file(folder / "job.json");
  } catch (const InputError&) {
    return std::nullopt;
  }
}

// How many targets the plan judges from this job alone.
std::size_t targets_of(const Plan& plan, std::size_t job) {
  return static_cast<std::size_t>(
      std::count_if(plan.targets.begin(), plan.targets.end(),
                    [&](const auto& target) { return target.jobs == std::vector<std::size_t>{job}; }));
}

// Outcomes that may have had their cause in the machine, and not in the renderer.
bool is_worth_another_try(JobOutcome outcome) {
  switch (outcome) {
    case JobOutcome::Crash:
    case JobOutcome::Timeout:
    case JobOutcome::OutOfMemory:
    case JobOutcome::NoOutput:
    case JobOutcome::Unreadable:
    case JobOutcome::Stale:
    case JobOutcome::Skipped:
      return true;
    case JobOutcome::Image:
    case JobOutcome::Unsupported:
    case JobOutcome::InvalidPixels:
    case JobOutcome::WrongChannels:
    case JobOutcome::WrongSize:
      return false;
  }
  return false;
}

// Why an existing render must be rendered again; nothing when it need not. A crash, a timeout or a missing
// image may have had its cause in the machine and is always tried again.
std::optional<std::string> why_outdated(const JobRecord& found, const JobRecord& now) {
  if (found.identity.id != now.identity.id) return "its samples or its seed have changed";
  if (found.hashes.scene != now.hashes.scene) return "its scene has changed";
  if (found.program.version != now.program.version)
    return fmt::format("it was rendered by '{}', now there is '{}'", found.program.version,
                       now.program.version);
  if (found.hashes.settings != now.hashes.settings) return "its command, environment or threads have changed";
  if (found.hashes.program != now.hashes.program)
    return "its program, or a file that its command names, has changed";
  if (found.hashes.files != now.hashes.files)
    return "its scene file or image in the folder of the run has changed";
  // An image that was finished within the old limits is the same under new ones.
  if (!has_image(found) && found.hashes.limits != now.hashes.limits) return "its limits have changed";
  if (is_worth_another_try(found.end.outcome))
    return fmt::format("it ended without an image ({}) and is tried again",
                       job_outcome_name(found.end.outcome));
  return std::nullopt;
}

}  // namespace

Resumption resumption_of(const Plan& plan,
                         std::size_t job,
                         const JobRecord& now,
                         const WorkFolders& folders) {
  const auto& planned = plan.jobs[job];
  auto found = found_job(folders.run / planned.folder);
  if (!found) return {};
  auto today = now;
  today.hashes.files = files_hash(plan, planned, found->job, folders.run);
  if (auto reason = why_outdated(found->job, today)) return {Step::Render, std::move(*reason)};
  const bool is_judged =
      found->job.hashes.judged == now.hashes.judged && found->targets.size() == targets_of(plan, job);
  return {is_judged ? Step::Keep : Step::Judge, "", std::move(found)};
}

std::optional<Execution> take_over(const JobRecord& found,
                                   const fs::path& folder,
                                   const WorkFolders& folders) {
  Execution execution{found, {}};
  try {
    if (has_image(found)) execution.image = image::read_image(folders.run / found.files.image);
  } catch (const InputError&) {
    return std::nullopt;
  }
  const auto unfinished = folders.unfinished / folder;
  make_folder(unfinished);
  for (const auto& entry : fs::directory_iterator(folders.run / folder))
    if (entry.symlink_status().type() == fs::file_type::regular && entry.path().filename() != "job.json")
      fs::copy_file(entry.path(), unfinished / entry.path().filename());
  return execution;
}

}  // namespace orbs::run
