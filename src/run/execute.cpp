#include "run/execute.h"

#include "adapters/process/process.h"
#include "base/files.h"
#include "base/local_time.h"
#include "base/text.h"
#include "run/condition.h"
#include "run/host.h"
#include "run/isolate.h"
#include "run/job_folder.h"
#include "run/prepare.h"
#include "run/render.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::run {

namespace {

using results::JobOutcome;
using results::JobRecord;

// The replicas of the job, with the scene written into its folder and with all that will prove that their
// images belong to this job.
std::vector<adapters::Job> prepare_replicas(const Plan& plan,
                                            const PlannedJob& planned,
                                            const scene::Scene& prepared,
                                            const WorkFolders& folders) {
  auto replicas = replicas_of(plan, planned, folders.unfinished);
  const auto& first = replicas.front();
  make_own_folder(folders.run, first.folder);
  write_job_scene(plan, planned, prepared, first);
  const auto scene_file_hash = hash_text(content_hash(read_file(first.scene_file)));
  // By the clock of that disk, as the image will be.
  const auto ready_since = std::filesystem::last_write_time(first.scene_file);
  for (auto& job : replicas) {
    job.id = planned.id;
    job.scene_file_hash = scene_file_hash;
    job.ready_since = ready_since;
    job.may_be_negative = planned.may_be_negative;
  }
  return replicas;
}

RenderJob render_job(const Plan& plan,
                     const PlannedJob& planned,
                     const scene::Scene& prepared,
                     const WorkFolders& folders) {
  const auto& renderer = plan.renderers[planned.renderer];
  const auto& scene = plan.scenes[planned.scene];
  RenderJob job{renderer.entry, prepare_replicas(plan, planned, prepared, folders)};
  job.renderer.limits = limits_of(plan, planned);
  job.within = folders.run;
  if (plan.settings.sandbox)
    job.isolation = isolation_of(plan, renderer, *scene.scene, job.replicas, folders.run);
  if (!plan.images.empty()) {
    job.came_back = plan.images / planned.folder;
  } else {
    job.inputs = files_of(*scene.scene);
    job.inputs.insert(job.inputs.end(), {scene.file, job.replicas.front().scene_file});
  }
  return job;
}

// How the last process ended, and the cost of all of them.
void note_processes(const Rendered& rendered, JobRecord& record) {
  auto& cost = record.cost;
  for (const auto& process : rendered.processes) {
    cost.wall_seconds += process.wall_seconds;
    cost.cpu_seconds += process.user_seconds + process.system_seconds;
    cost.peak_rss_bytes = std::max(cost.peak_rss_bytes, process.peak_rss_bytes);
  }
  cost.render_seconds = rendered.render_seconds;
  const auto& last = rendered.processes.back();
  record.end.exit_code = last.exit_code;
  record.end.core_dumped = last.core_dumped;
  if (last.signal != 0) record.end.signal = adapters::signal_name(last.signal);
}

// The commands that repeat the renders: words relative to the folder of the job, lines for a shell in that of
// the run, so that both hold wherever the run is moved.
void note_command(const std::vector<adapters::Job>& replicas,
                  const std::filesystem::path& folder,
                  const std::vector<std::string>& environment,
                  JobRecord& record) {
  std::vector<std::string> commands;
  for (const auto& job : replicas) {
    auto words = job.argv;
    for (auto& word : words) word = named_within(job.folder, std::move(word));
    commands.push_back(shell_command(environment, words));
    if (record.program.argv.empty()) record.program.argv = std::move(words);
  }
  record.program.shell =
      fmt::format("cd {} && {}", shell_text({folder.string()}), fmt::join(commands, " && "));
}

}  // namespace

JobRecord skipped_record(const Plan& plan, const PlannedJob& job) {
  JobRecord record;
  const auto& renderer = plan.renderers[job.renderer].entry;
  record.identity = {job.id,  plan.suite.name,    plan.scenes[job.scene].name, renderer.name,
                     job.spp, plan.settings.seed, renderer.sampling.seeds};
  record.program.threads = plan.threads;
  record.files.folder = job.folder.string();
  if (!job.native_scene.empty())
    record.files.native_scene = job.native_scene.lexically_proximate(plan.root).string();
  record.end.reason = "the run ended before its turn";
  return record;
}

Execution execute(const Plan& plan,
                  const PlannedJob& planned,
                  const std::string& version,
                  const WorkFolders& folders,
                  const std::atomic<bool>* stop) {
  const auto& chosen = plan.renderers[planned.renderer];
  Execution execution{skipped_record(plan, planned), {}};
  auto& record = execution.record;
  record.program.version = version;
  const auto prepared = scene_for(plan, planned);
  if (const auto* reason = std::get_if<std::string>(&prepared)) {
    record.end.outcome = JobOutcome::Unsupported;
    record.end.reason = *reason;
    return execution;
  }
  const auto job = render_job(plan, planned, std::get<scene::Scene>(prepared), folders);
  const auto folder = job.replicas.front().folder;
  note_command(job.replicas, planned.folder, environment_of(chosen.entry, job.replicas.front()), record);
  if (job.came_back.empty()) {
    record.cost.started = local_time_now();
    record.cost.load = load_average();
  }
  // Before the render that is judged, whose log stays.
  if (planned.has_condition) record.condition = measure_condition(plan, planned, job, stop, record.cost);
  auto rendered = render(job, stop);
  note_processes(rendered, record);
  record.end.outcome = rendered.outcome.kind;
  record.end.reason = rendered.outcome.reason;
  if (results::leaves_visible_image(rendered.outcome.kind))
    record.files.image = (planned.folder / rendered.image.filename()).string();
  const bool keep_log = plan.settings.log || !has_image(record);
  if (keep_log) record.files.log = (planned.folder / "log.txt").string();
  std::error_code ignored;
  if (!keep_log) std::filesystem::remove(folder / "log.txt", ignored);
  execution.image = std::move(rendered.outcome.image);
  execution.renders = std::move(rendered.renders);
  return execution;
}

}  // namespace orbs::run
