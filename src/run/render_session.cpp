#include "run/render_session.h"

#include "base/error.h"
#include "base/files.h"
#include "run/expected.h"
#include "run/job_folder.h"
#include "run/resume.h"

#include <utility>

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
Execution execute_or_say_why(const RenderSession& session,
                             const PlannedJob& job,
                             const std::string& version) {
  Execution execution{skipped_record(session.plan, job), {}};
  try {
    return execute(session.plan, job, version, session.folders, session.context.stop);
  } catch (const WriteError&) {
    throw;
  } catch (const InputError& e) {
    refuse_full_disk(session.folders.run);
    execution.record.program.version = version;
    execution.record.end.outcome = JobOutcome::Crash;
    execution.record.end.reason = fmt::format("could not start: {}", e.what());
    return execution;
  }
}

}  // namespace

bool is_stopped(const RenderSession& session) {
  return session.context.stop != nullptr && session.context.stop->load();
}

void say(RenderSession& session, const JobRecord& job, const std::string& what) {
  const std::lock_guard lock(session.mutex);
  if (session.context.say)
    session.context.say(fmt::format("{} {}: {}", job.identity.renderer, job.identity.scene, what));
}

Execution render_job(RenderSession& session, std::size_t index, const PlannedJob& job) {
  const auto& now = session.at_start[index];
  if (const std::lock_guard lock(session.mutex); session.context.started)
    session.context.started(now.identity);
  auto execution = execute_or_say_why(session, job, now.program.version);
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

JudgedJob skipped_job(const RenderSession& session, std::size_t index, const JobRecord& record) {
  std::error_code ignored;
  fs::remove_all(session.folders.unfinished / session.plan.jobs[index].folder, ignored);
  JudgedJob skipped{record, {}, {}};
  for (auto& target : judge_scene(session.plan, index, {skipped.job, {}}, session.folders)) {
    skipped.targets.push_back(std::move(target.record));
    skipped.looks.emplace_back();
  }
  return skipped;
}

JudgedJob judge_job(RenderSession& session, std::size_t index, Execution execution) {
  const auto& folders = session.folders;
  const auto& job = session.plan.jobs[index];
  auto& record = execution.record;
  if (!has_image(record) && record.end.outcome != JobOutcome::Unsupported) refuse_full_disk(folders.run);
  const auto program = record.hashes.program;
  record.hashes = session.at_start[index].hashes;
  record.hashes.program = program;
  record.hashes.files = files_hash(session.plan, job, record, folders.unfinished);
  record.hashes.image = image_hash(record, folders.unfinished);
  make_own_folder(folders.run, folders.unfinished / job.folder);
  JudgedJob judged;
  for (auto& target : judge_scene(session.plan, index, execution, folders)) {
    judged.targets.push_back(std::move(target.record));
    judged.looks.push_back(target.look);
  }
  judged.job = std::move(record);
  return judged;
}

void place_job(RenderSession& session, std::size_t index, JudgedJob& judged) {
  const auto& folders = session.folders;
  const auto& folder = session.plan.jobs[index].folder;
  write_job(session, folders.unfinished / folder, judged);
  make_own_folder(folders.run, (folders.run / folder).parent_path());
  put_in_place(folders.unfinished / folder, folders.run / folder);
}

void write_job(const RenderSession& session, const fs::path& folder, JudgedJob& judged) {
  const auto& plan = session.plan;
  mark_expected(plan.expected,
                {plan.suite.name, plan.settings.size_divisor, session.context.day, plan.settings.strict},
                {{judged.job.identity.renderer, judged.job.program.version}}, judged.targets);
  write_file(folder / "job.json", results::job_json(judged.job, judged.targets));
}

void count_done(RenderSession& session, const JudgedJob& judged, bool is_news) {
  const std::lock_guard lock(session.mutex);
  ++session.done;
  if (is_news && session.context.progress)
    session.context.progress(session.done, session.plan.jobs.size(), judged.job, judged.targets);
}

}  // namespace orbs::run
