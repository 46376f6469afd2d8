#include "run/render_jobs.h"

#include "base/error.h"
#include "base/files.h"
#include "base/parallel.h"
#include "image/image_io.h"
#include "results/read_record.h"
#include "results/record_json.h"
#include "run/expected.h"
#include "run/host.h"
#include "run/judge_targets.h"
#include "run/outdated.h"
#include "run/plan/shipped_times.h"
#include "run/program_hash.h"

#include <algorithm>
#include <mutex>
#include <numeric>
#include <optional>

#include <fmt/format.h>

namespace orbs::run {

namespace {

namespace fs = std::filesystem;
using results::JobFile;
using results::JobOutcome;
using results::JobRecord;

bool is_stopped(const RenderContext& context) { return context.stop != nullptr && context.stop->load(); }

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

std::string image_hash(const JobRecord& record, const fs::path& folder) {
  const auto file = folder / record.files.image;
  if (record.files.image.empty() || !no_file_problem(file).empty()) return "";
  return hash_text(content_hash(read_file(file)));
}

// On a full disk a renderer fails, too, and that is not its fault.
void refuse_full_disk(const fs::path& folder) {
  constexpr std::uintmax_t kLeast_bytes = 1 << 20;
  std::error_code failed;
  const auto space = fs::space(folder, failed);
  if (!failed && space.available < kLeast_bytes)
    throw WriteError(fmt::format("{}: the disk is full", folder.string()));
}

// A scene that cannot be written for its renderer spoils that job alone.
Execution execute_or_say_why(const Plan& plan,
                             const PlannedJob& job,
                             const std::string& version,
                             const WorkFolders& folders,
                             const RenderContext& context) {
  Execution execution{skipped_record(plan, job), {}};
  try {
    return execute(plan, job, version, folders, context.stop);
  } catch (const WriteError&) {
    throw;
  } catch (const InputError& e) {
    refuse_full_disk(folders.run);
    execution.record.program.version = version;
    execution.record.end.outcome = JobOutcome::Crash;
    execution.record.end.reason = fmt::format("could not start: {}", e.what());
    return execution;
  }
}

// The render of an earlier run in an unfinished folder of its own, to be judged by what has changed. Nothing
// when its image is gone or cannot be read any more.
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

// How many targets the plan judges from this job alone.
std::size_t targets_of(const Plan& plan, std::size_t job) {
  return static_cast<std::size_t>(
      std::count_if(plan.targets.begin(), plan.targets.end(),
                    [&](const auto& target) { return target.jobs == std::vector<std::size_t>{job}; }));
}

// Carries out jobs from several threads and collects their records.
class JobRunner {
 public:
  JobRunner(const Plan& plan,
            const std::vector<std::string>& versions,
            const WorkFolders& folders,
            const RenderContext& context)
      : plan_(plan),
        versions_(versions),
        folders_(folders),
        context_(context),
        judged_{std::vector<JobRecord>(plan.jobs.size()),
                std::vector<std::vector<results::TargetRecord>>(plan.jobs.size())} {
    for (const auto& renderer : plan.renderers)
      programs_.push_back(program_hash(renderer, plan, file_hashes_));
    for (std::size_t index = 0; index < plan.jobs.size(); ++index)
      at_start_.push_back(record_at_start(index));
  }

  void run_or_keep(std::size_t index) {
    const auto& job = plan_.jobs[index];
    auto now = at_start_[index];
    auto found = found_job(folders_.run / job.folder);
    if (found) now.hashes.files = files_hash(plan_, job, found->job, folders_.run);
    auto reason = found ? why_outdated(found->job, now) : std::nullopt;
    if (found && !reason && found->job.hashes.judged == now.hashes.judged &&
        found->targets.size() == targets_of(plan_, index)) {
      keep(index, std::move(*found));
      return;
    }
    if (is_stopped(context_)) {
      skip(index, now);
      return;
    }
    if (reason) say(fmt::format("{} {}: {}", now.identity.renderer, now.identity.scene, *reason));
    auto execution = found && !reason ? take_over(found->job, job.folder, folders_) : std::nullopt;
    finish(index, execution ? std::move(*execution) : render(job), now);
  }

  JudgedJobs take() { return std::move(judged_); }

 private:
  // Everything that the render depends on is hashed before the first render starts. A file that is replaced
  // later then differs from its hash, and --resume notices.
  JobRecord record_at_start(std::size_t index) const {
    const auto& job = plan_.jobs[index];
    auto record = skipped_record(plan_, job);
    record.program.version = versions_[job.renderer];
    record.hashes = {scene_hash(plan_, job),
                     programs_[job.renderer],
                     "",
                     settings_hash(plan_, job),
                     limits_hash(plan_, job),
                     judged_hash(plan_, index, folders_.references, context_.orbs_version),
                     ""};
    return record;
  }

  Execution render(const PlannedJob& job) {
    if (const std::lock_guard lock(mutex_); context_.started)
      context_.started(skipped_record(plan_, job).identity);
    auto execution = execute_or_say_why(plan_, job, versions_[job.renderer], folders_, context_);
    if (plan_.images.empty()) execution.record.cost.host = host_;
    execution.record.hashes.program = programs_[job.renderer];
    if (program_hash(plan_.renderers[job.renderer], plan_, file_hashes_) != programs_[job.renderer]) {
      execution.record.hashes.program = "";
      say(
          fmt::format("{} {}: its program, or a file that its command names, has changed since the run "
                      "started; --resume renders it again",
                      execution.record.identity.renderer, execution.record.identity.scene));
    }
    return execution;
  }

  void keep(std::size_t index, JobFile found) {
    judged_.jobs[index] = std::move(found.job);
    judged_.targets[index] = std::move(found.targets);
    const std::lock_guard lock(mutex_);
    ++done_;
  }

  // Leaves nothing on disk, so that a resumed run renders it.
  void skip(std::size_t index, const JobRecord& record) {
    judged_.targets[index] = judge_scene(plan_, index, {record, {}}, folders_);
    judged_.jobs[index] = record;
  }

  void finish(std::size_t index, Execution execution, const JobRecord& now) {
    const auto& folder = plan_.jobs[index].folder;
    if (execution.record.end.outcome == JobOutcome::Skipped) {
      std::error_code ignored;
      fs::remove_all(folders_.unfinished / folder, ignored);
      skip(index, execution.record);
      return;
    }
    if (!has_image(execution.record) && execution.record.end.outcome != JobOutcome::Unsupported)
      refuse_full_disk(folders_.run);
    const auto program = execution.record.hashes.program;
    execution.record.hashes = now.hashes;
    execution.record.hashes.program = program;
    execution.record.hashes.files =
        files_hash(plan_, plan_.jobs[index], execution.record, folders_.unfinished);
    execution.record.hashes.image = image_hash(execution.record, folders_.unfinished);
    make_folder(folders_.unfinished / folder);
    judged_.targets[index] = judge_scene(plan_, index, execution, folders_);
    mark_expected(plan_.expected, {{now.identity.renderer, now.program.version}}, judged_.targets[index]);
    write_file(folders_.unfinished / folder / "job.json",
               results::job_json(execution.record, judged_.targets[index]));
    put_in_place(folders_.unfinished / folder, folders_.run / folder);
    judged_.jobs[index] = std::move(execution.record);
    report(index);
  }

  void report(std::size_t index) {
    const std::lock_guard lock(mutex_);
    ++done_;
    if (context_.progress)
      context_.progress(done_, plan_.jobs.size(), judged_.jobs[index], judged_.targets[index]);
  }

  void say(const std::string& line) {
    const std::lock_guard lock(mutex_);
    if (context_.say) context_.say(line);
  }

  const Plan& plan_;
  const std::vector<std::string>& versions_;
  const WorkFolders& folders_;
  const RenderContext& context_;
  const results::Host host_ = this_host();
  FileHashes file_hashes_;
  std::vector<std::string> programs_;  // by renderer: its program_hash
  std::vector<JobRecord> at_start_;    // by job
  JudgedJobs judged_;
  std::mutex mutex_;
  std::size_t done_ = 0;
};

// The order of the plan shows something of each requirement early. With several jobs at a time the longest
// ones start first, or the last of them would run alone while the other cores wait.
std::vector<std::size_t> order_of_starts(const Plan& plan) {
  std::vector<std::size_t> order(plan.jobs.size());
  std::iota(order.begin(), order.end(), 0);
  if (plan.settings.jobs == 1) return order;
  const auto seconds = estimated_cpu_seconds(plan);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return seconds[a] > seconds[b]; });
  return order;
}

}  // namespace

JudgedJobs render_jobs(const Plan& plan,
                       const std::vector<std::string>& versions,
                       const WorkFolders& folders,
                       const RenderContext& context) {
  JobRunner runner(plan, versions, folders, context);
  const auto order = order_of_starts(plan);
  for_each_index(static_cast<int>(plan.jobs.size()), plan.settings.jobs,
                 [&](int index) { runner.run_or_keep(order[static_cast<std::size_t>(index)]); });
  return runner.take();
}

}  // namespace orbs::run
