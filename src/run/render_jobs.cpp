#include "run/render_jobs.h"

#include "base/error.h"
#include "base/files.h"
#include "base/nth.h"
#include "base/parallel.h"
#include "results/record.h"
#include "run/expected.h"
#include "run/host.h"
#include "run/job_folder.h"
#include "run/judge_targets.h"
#include "run/resume.h"

#include <algorithm>
#include <mutex>
#include <numeric>

#include <fmt/format.h>

namespace orbs::run {

namespace {

namespace fs = std::filesystem;
using results::JobOutcome;
using results::JobRecord;

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

// What the threads share: the record of each job before it is rendered, and the callers' functions, which are
// called by one thread at a time.
struct Session {
  const Plan& plan;
  const WorkFolders& folders;
  const RenderContext& context;
  ProgramWatch& programs;
  std::vector<JobRecord> at_start{};  // by job
  results::Host host = this_host();
  std::mutex mutex{};
  std::size_t done = 0;
};

// Everything that the render depends on is hashed before the first render starts. A file that is replaced
// later then differs from its hash, and --resume notices.
std::vector<JobRecord> records_at_start(const Session& session, const std::vector<std::string>& versions) {
  std::vector<JobRecord> records;
  const auto& plan = session.plan;
  for (std::size_t index = 0; index < plan.jobs.size(); ++index) {
    const auto& job = plan.jobs[index];
    auto& record = records.emplace_back(skipped_record(plan, job));
    record.program.version = versions[job.renderer];
    record.hashes = {scene_hash(plan, job),
                     session.programs.hash(job.renderer),
                     "",
                     settings_hash(plan, job),
                     limits_hash(plan, job),
                     judged_hash(plan, index, session.folders.references, session.context.orbs_version),
                     ""};
  }
  return records;
}

void say(Session& session, const JobRecord& job, const std::string& what) {
  const std::lock_guard lock(session.mutex);
  if (session.context.say)
    session.context.say(fmt::format("{} {}: {}", job.identity.renderer, job.identity.scene, what));
}

Execution rendered(Session& session, std::size_t index) {
  const auto& now = session.at_start[index];
  const auto& job = session.plan.jobs[index];
  if (const std::lock_guard lock(session.mutex); session.context.started)
    session.context.started(now.identity);
  auto execution =
      execute_or_say_why(session.plan, job, now.program.version, session.folders, session.context);
  if (session.plan.images.empty()) execution.record.cost.host = session.host;
  execution.record.hashes.program = now.hashes.program;
  if (session.programs.has_changed(job.renderer)) {
    execution.record.hashes.program = "";
    say(session, now,
        "its program, or a file that its command names, has changed since the run started; --resume renders it "
        "again");
  }
  return execution;
}

// Leaves nothing on disk, so that a resumed run renders it.
JudgedJob skipped(const Session& session, std::size_t index, const JobRecord& record) {
  std::error_code ignored;
  fs::remove_all(session.folders.unfinished / session.plan.jobs[index].folder, ignored);
  return {record, judge_scene(session.plan, index, {record, {}}, session.folders)};
}

// Judges the render and puts its folder in place.
JudgedJob judged(Session& session, std::size_t index, Execution execution) {
  const auto& folders = session.folders;
  const auto& job = session.plan.jobs[index];
  auto& record = execution.record;
  if (record.end.outcome == JobOutcome::Skipped) return skipped(session, index, record);
  if (!has_image(record) && record.end.outcome != JobOutcome::Unsupported) refuse_full_disk(folders.run);
  const auto program = record.hashes.program;
  record.hashes = session.at_start[index].hashes;
  record.hashes.program = program;
  record.hashes.files = files_hash(session.plan, job, record, folders.unfinished);
  record.hashes.image = image_hash(record, folders.unfinished);
  make_own_folder(folders.run, folders.unfinished / job.folder);
  auto targets = judge_scene(session.plan, index, execution, folders);
  const auto& plan = session.plan;
  mark_expected(plan.expected,
                {plan.suite.name, plan.settings.size_divisor, session.context.day, plan.settings.strict},
                {{record.identity.renderer, record.program.version}}, targets);
  write_file(folders.unfinished / job.folder / "job.json", results::job_json(record, targets));
  make_own_folder(folders.run, (folders.run / job.folder).parent_path());
  put_in_place(folders.unfinished / job.folder, folders.run / job.folder);
  const std::lock_guard lock(session.mutex);
  ++session.done;
  if (session.context.progress)
    session.context.progress(session.done, session.plan.jobs.size(), record, targets);
  return {std::move(record), std::move(targets)};
}

JudgedJob run_or_keep(Session& session, std::size_t index) {
  const auto& now = session.at_start[index];
  auto earlier = resumption_of(session.plan, index, now, session.folders);
  if (earlier.step == Step::Keep) {
    const std::lock_guard lock(session.mutex);
    ++session.done;
    return {std::move(earlier.found->job), std::move(earlier.found->targets)};
  }
  if (session.context.stop != nullptr && session.context.stop->load()) return skipped(session, index, now);
  if (!earlier.reason.empty()) say(session, now, earlier.reason);
  auto execution = earlier.step == Step::Judge
                       ? take_over(earlier.found->job, session.plan.jobs[index].folder, session.folders)
                       : std::nullopt;
  return judged(session, index, execution ? std::move(*execution) : rendered(session, index));
}

// The order of the plan shows something of each requirement early. With several jobs at a time the longest
// ones start first, or the last of them would run alone while the other cores wait.
std::vector<std::size_t> order_of_starts(const Plan& plan) {
  std::vector<std::size_t> order(plan.jobs.size());
  std::iota(order.begin(), order.end(), 0);
  if (plan.settings.jobs == 1) return order;
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return plan.jobs[a].cpu_seconds > plan.jobs[b].cpu_seconds; });
  return order;
}

}  // namespace

std::vector<JudgedJob> render_jobs(const Plan& plan,
                                   const std::vector<std::string>& versions,
                                   const WorkFolders& folders,
                                   const RenderContext& context,
                                   ProgramWatch& programs) {
  Session session{plan, folders, context, programs};
  session.at_start = records_at_start(session, versions);
  const auto order = order_of_starts(plan);
  std::vector<JudgedJob> jobs(plan.jobs.size());
  for_each_index(static_cast<int>(plan.jobs.size()), plan.settings.jobs, [&](int turn) {
    const auto index = nth(order, turn);
    jobs[index] = run_or_keep(session, index);
  });
  return jobs;
}

}  // namespace orbs::run
