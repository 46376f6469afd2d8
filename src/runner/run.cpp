#include "runner/run.h"

#include "base/error.h"
#include "base/files.h"
#include "base/parallel.h"
#include "image/image_io.h"
#include "results/record_json.h"
#include "results/run_folder.h"
#include "runner/execute.h"
#include "runner/judge.h"
#include "runner/summary.h"

#include <array>
#include <chrono>
#include <ctime>
#include <mutex>

#include <fmt/format.h>

namespace orbs::runner {

namespace {

using results::JobRecord;
using results::PictureRecord;
using results::Verdict;

constexpr const char* kReferences = "references";

PictureRecord blank_picture(const Plan& plan,
                            const PlannedPicture& planned,
                            const std::filesystem::path& folder) {
  const auto& one_case = plan.cases[planned.one_case];
  PictureRecord record;
  record.requirement = one_case.requirement;
  record.case_name = one_case.name;
  record.picture = planned.picture;
  record.renderer = plan.renderers[planned.renderer].entry.name;
  record.declared = planned.declared;
  for (const auto job : planned.jobs) record.jobs.push_back(plan.jobs[job].id);
  const auto reference = std::filesystem::path(kReferences) / (planned.picture + ".exr");
  if (std::filesystem::exists(folder / reference)) record.reference_image = reference.string();
  return record;
}

PictureRecord undeclared_picture(const Plan& plan,
                                 const PlannedPicture& planned,
                                 const std::filesystem::path& folder) {
  auto record = blank_picture(plan, planned, folder);
  record.verdict = Verdict::Unsupported;
  record.sentence = fmt::format("{} does not declare {}", record.renderer, record.requirement);
  if (const auto reason = registry::limit_reason(plan.renderers[planned.renderer].entry, record.requirement))
    record.sentence += fmt::format(": {}", *reason);
  return record;
}

// What became of the render is what there is to say about its picture.
void take_job_verdict(const JobRecord& job, PictureRecord& record) {
  record.verdict = job.verdict;
  record.sentence = job.sentence;
}

// Judges one picture that is there, and writes its maps unless another case has done so.
void judge_picture(const Plan& plan,
                   const PlannedPicture& planned,
                   const image::Image& result,
                   const std::filesystem::path& folder,
                   PictureRecord& record) {
  const auto& one_case = plan.cases[planned.one_case];
  const auto reference =
      load_reference(one_case, planned.picture, plan.suite.references, plan.reference_hashes);
  const auto comparison = judge(one_case, result, reference, plan.threads, record);
  if (!comparison) return;
  const auto relative = std::filesystem::path(record.renderer) / record.picture;
  record.maps = write_maps(result, *comparison, folder / relative);
  for (auto& map : record.maps) map.image = (relative / map.image).string();
}

// All pictures that this render alone makes: one for each case that looks at it.
std::vector<PictureRecord> judge_scene(const Plan& plan,
                                       std::size_t job,
                                       const Execution& execution,
                                       const std::filesystem::path& folder) {
  std::vector<PictureRecord> records;
  for (const auto& planned : plan.pictures) {
    if (planned.jobs.size() != 1 || planned.jobs.front() != job) continue;
    auto& record = records.emplace_back(blank_picture(plan, planned, folder));
    record.image = execution.record.image;
    if (execution.picture) {
      judge_picture(plan, planned, *execution.picture, folder, record);
    } else {
      take_job_verdict(execution.record, record);
    }
  }
  return records;
}

PictureRecord judge_difference(const Plan& plan,
                               const PlannedPicture& planned,
                               const std::vector<JobRecord>& jobs,
                               const std::filesystem::path& folder) {
  auto record = blank_picture(plan, planned, folder);
  for (const auto job : planned.jobs)
    if (!jobs[job].rendered) {
      take_job_verdict(jobs[job], record);
      record.sentence = fmt::format("its scene '{}': {}", jobs[job].scene, jobs[job].sentence);
      return record;
    }
  const auto of = image::read_image(folder / jobs[planned.jobs[0]].image);
  const auto minus = image::read_image(folder / jobs[planned.jobs[1]].image);
  const auto result = difference_of(of, minus);
  const auto relative = std::filesystem::path(record.renderer) / record.picture;
  std::filesystem::create_directories(folder / relative);
  image::write_exr(result, folder / relative / "result.exr");
  record.image = (relative / "result.exr").string();
  judge_picture(plan, planned, result, folder, record);
  return record;
}

// Renders of one run, filled by the workers.
struct Work {
  std::vector<JobRecord> jobs;
  std::vector<std::vector<PictureRecord>> pictures;  // by job
};

bool is_stopped(const RunContext& context) { return context.stop != nullptr && context.stop->load(); }

// A scene that cannot be written for its renderer spoils that job alone.
Execution execute_or_say_why(const Plan& plan,
                             const PlannedJob& job,
                             const std::string& version,
                             const std::filesystem::path& folder,
                             const RunContext& context) {
  Execution execution{skipped_record(plan, job), {}};
  if (is_stopped(context)) return execution;
  try {
    return execute(plan, job, version, folder, context.stop);
  } catch (const InputError& e) {
    execution.record.verdict = Verdict::Crash;
    execution.record.sentence = fmt::format("could not start: {}", e.what());
    return execution;
  }
}

Work render_all(const Plan& plan,
                const std::vector<std::string>& versions,
                const std::filesystem::path& folder,
                const RunContext& context) {
  Work work{std::vector<JobRecord>(plan.jobs.size()),
            std::vector<std::vector<PictureRecord>>(plan.jobs.size())};
  std::mutex mutex;
  std::size_t done = 0;
  for_each_index(static_cast<int>(plan.jobs.size()), plan.settings.jobs, [&](int index) {
    const auto i = static_cast<std::size_t>(index);
    const auto& job = plan.jobs[i];
    auto execution = execute_or_say_why(plan, job, versions[job.renderer], folder, context);
    work.pictures[i] = judge_scene(plan, i, execution, folder);
    // What cannot be prepared for its renderer made no folder, but whoever watches waits for its file.
    if (execution.record.verdict == Verdict::Unsupported)
      std::filesystem::create_directories(folder / job.folder);
    if (std::filesystem::is_directory(folder / job.folder))
      write_file(folder / job.folder / "job.json", results::job_json(execution.record, work.pictures[i]));
    work.jobs[i] = std::move(execution.record);
    const std::lock_guard lock(mutex);
    if (context.progress) context.progress(++done, plan.jobs.size(), work.jobs[i], work.pictures[i]);
  });
  return work;
}

// In the order of the plan, whatever order the renders ended in.
std::vector<PictureRecord> all_pictures(const Plan& plan, Work& work, const std::filesystem::path& folder) {
  std::vector<PictureRecord> records;
  std::vector<std::size_t> taken(plan.jobs.size(), 0);
  for (const auto& planned : plan.pictures) {
    if (planned.jobs.empty()) {
      records.push_back(undeclared_picture(plan, planned, folder));
    } else if (planned.jobs.size() == 1) {
      const auto job = planned.jobs.front();
      records.push_back(work.pictures[job][taken[job]++]);
    } else {
      records.push_back(judge_difference(plan, planned, work.jobs, folder));
    }
  }
  return records;
}

}  // namespace

std::filesystem::path make_run_folder(const std::string& wanted) {
  std::error_code failed;
  if (!wanted.empty()) {
    const auto folder = std::filesystem::absolute(wanted).lexically_normal();
    const bool is_taken = std::filesystem::exists(folder) && !(std::filesystem::is_directory(folder) &&
                                                               std::filesystem::is_empty(folder, failed));
    if (is_taken)
      throw InputError(
          fmt::format("{}: exists already; name a new or empty folder with -o", folder.string()));
    std::filesystem::create_directories(folder, failed);
    if (failed)
      throw InputError(fmt::format("{}: the folder cannot be made: {}", folder.string(), failed.message()));
    return folder;
  }
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  ::localtime_r(&now, &local);
  std::array<char, 32> stamp{};
  std::strftime(stamp.data(), stamp.size(), "outputs-%y%m%d-%H%M%S", &local);
  for (int number = 1;; ++number) {
    const auto name = number == 1 ? std::string(stamp.data()) : fmt::format("{}-{}", stamp.data(), number);
    const auto folder = std::filesystem::absolute(name);
    // False when it exists: two runs that start in the same second take different names.
    if (std::filesystem::create_directory(folder, failed)) return folder;
    if (failed)
      throw InputError(fmt::format("{}: the folder cannot be made: {}", folder.string(), failed.message()));
  }
}

namespace {

// The record before anything is rendered: every picture that can be rendered waits for its turn.
results::RunRecord record_at_start(const Plan& plan,
                                   const std::vector<std::string>& versions,
                                   const std::filesystem::path& folder,
                                   const RunContext& context) {
  results::RunRecord record;
  record.suite = plan.suite.name;
  record.folder = folder.string();
  record.started = local_time_now();
  record.orbs_version = context.orbs_version;
  record.command_line = context.command_line;
  record.host = this_host();
  record.left_out = plan.left_out;
  record.finished = false;
  for (const auto& one_case : plan.cases)
    record.cases.push_back({plan.suite.name, one_case.name, one_case.requirement, one_case.title,
                            one_case.tests, one_case.typical_mistake});
  for (const auto& job : plan.jobs) record.jobs.push_back(skipped_record(plan, job));
  for (const auto& planned : plan.pictures) {
    if (planned.jobs.empty()) {
      record.pictures.push_back(undeclared_picture(plan, planned, folder));
    } else {
      record.pictures.push_back(blank_picture(plan, planned, folder));
      take_job_verdict(record.jobs[planned.jobs.front()], record.pictures.back());
    }
  }
  summarise(plan, versions, record);
  return record;
}

}  // namespace

results::RunRecord run(const Plan& plan, const std::filesystem::path& folder, const RunContext& context) {
  const auto start = std::chrono::steady_clock::now();
  const results::RunLock lock(folder);
  std::vector<std::string> versions;
  for (const auto& renderer : plan.renderers) versions.push_back(renderer_version(renderer, plan));
  copy_references(plan.cases, plan.suite.references, folder / kReferences);
  auto record = record_at_start(plan, versions, folder, context);
  write_file(folder / "results.json", results::run_json(record));
  auto work = render_all(plan, versions, folder, context);
  record.pictures = all_pictures(plan, work, folder);
  record.jobs = std::move(work.jobs);
  record.interrupted = is_stopped(context);
  record.finished = true;
  summarise(plan, versions, record);
  record.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  // Before the lock is released: whoever sees that nothing runs any more must find the end of it.
  write_file(folder / "results.json", results::run_json(record));
  return record;
}

}  // namespace orbs::runner
