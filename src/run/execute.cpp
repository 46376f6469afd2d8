#include "run/execute.h"

#include "adapters/export.h"
#include "adapters/native_scene.h"
#include "adapters/process/isolation.h"
#include "adapters/process/process.h"
#include "adapters/process/programs.h"
#include "base/files.h"
#include "base/local_time.h"
#include "base/shell.h"
#include "image/image_io.h"
#include "metrics/seeds.h"
#include "run/host.h"
#include "run/job_folder.h"
#include "run/outcome.h"
#include "run/plan/job_limits.h"
#include "run/plan/render_seconds.h"
#include "run/prepare.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::run {

namespace {

using results::JobOutcome;
using results::JobRecord;

// Folders of runs beside this one hold copies of references, too.
std::vector<std::filesystem::path> folders_with_references(const Plan& plan,
                                                           const std::filesystem::path& run) {
  std::vector<std::filesystem::path> folders{plan.suite.references, run};
  std::error_code ignored;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::absolute(run).parent_path(), ignored))
    if (std::filesystem::exists(entry.path() / "results.json", ignored)) folders.push_back(entry.path());
  return folders;
}

adapters::ProcessRequest process_request(const registry::Renderer& renderer,
                                         const adapters::Job& job,
                                         const std::atomic<bool>* stop) {
  adapters::ProcessRequest request;
  request.argv = job.argv;
  request.argv[0] = adapters::find_program(job.argv[0]).value_or(job.argv[0]).string();
  request.folder = job.folder;
  auto allowed = renderer.command.environment;
  allowed.push_back(fmt::format("ORBS_JOB={}", job.id));
  request.environment = adapters::child_environment(allowed);
  request.log = job.folder / "log.txt";
  request.limits = renderer.limits;
  request.stop = stop;
  return request;
}

// The replicas of the job, with the scene written into its folder and with all that will prove that their
// images belong to this job.
std::vector<adapters::Job> prepare_replicas(const Plan& plan,
                                            const PlannedJob& planned,
                                            const scene::Scene& prepared,
                                            const std::filesystem::path& folder) {
  auto replicas = replicas_of(plan, planned, folder);
  const auto& first = replicas.front();
  make_folder(first.folder);
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

// Adds the cost to that of the earlier replicas; how the process ended replaces what they noted.
void note_process(const adapters::ProcessResult& process,
                  const registry::Renderer& renderer,
                  const std::filesystem::path& folder,
                  JobRecord& record) {
  auto& cost = record.cost;
  cost.wall_seconds += process.wall_seconds;
  cost.cpu_seconds += process.user_seconds + process.system_seconds;
  cost.peak_rss_bytes = std::max(cost.peak_rss_bytes, process.peak_rss_bytes);
  if (const auto seconds = render_seconds(renderer.timing.render_seconds, process.output, folder))
    cost.render_seconds = cost.render_seconds.value_or(0) + *seconds;
  record.end.exit_code = process.exit_code;
  record.end.core_dumped = process.core_dumped;
  if (process.signal != 0) record.end.signal = adapters::signal_name(process.signal);
}

// Writes the mean image of all replicas to `file` and removes their own images.
image::Image merged_image(const std::vector<adapters::Job>& replicas,
                          const std::vector<image::Image>& images,
                          const std::filesystem::path& file) {
  // A later replica may have left anything under any of these names.
  for (const auto& job : replicas) make_way(job.image);
  make_way(file);
  auto image = metrics::are_equal(images) ? images.front() : metrics::mean_and_variance_of(images);
  image::write_exr(image, file);
  return image;
}

// Puts the image that came back in the place where a renderer would have left it. Without one nothing was
// written.
adapters::ProcessResult take_image(const adapters::Job& job, const std::filesystem::path& from) {
  const auto image = from / job.image.filename();
  if (no_file_problem(image).empty()) write_file(job.image, read_file(image));
  return {};
}

// One process after the other, until one leaves no usable image. Returns the outcome and the file of the
// image.
std::pair<Outcome, std::filesystem::path> run_replicas(const std::vector<adapters::Job>& replicas,
                                                       const registry::Renderer& renderer,
                                                       const std::filesystem::path& came_back,
                                                       const std::optional<adapters::Isolation>& isolation,
                                                       const std::atomic<bool>* stop,
                                                       JobRecord& record) {
  std::vector<image::Image> images;
  for (const auto& job : replicas) {
    forget_render_seconds(renderer.timing.render_seconds, job.folder);
    auto request = process_request(renderer, job, stop);
    if (isolation) request.argv = adapters::isolated(request.argv, *isolation);
    const auto process = came_back.empty() ? adapters::run_process(request) : take_image(job, came_back);
    make_room(job.folder);
    note_process(process, renderer, job.folder, record);
    auto outcome = classify(process, job, renderer.limits);
    if (outcome.kind != JobOutcome::Image) return {std::move(outcome), job.image};
    if (replicas.size() == 1) {
      // All who read the file later expect R, G and B.
      if (job.channels != adapters::kColourChannels) image::write_exr(*outcome.image, job.image);
      return {std::move(outcome), job.image};
    }
    images.push_back(std::move(*outcome.image));
  }
  const auto file = replicas.front().folder / adapters::JobSettings{}.image_file;
  return {{JobOutcome::Image, "", merged_image(replicas, images, file)}, file};
}

// The commands that repeat the renders once the folder is in its place.
void note_command(const std::vector<adapters::Job>& replicas,
                  const std::vector<std::string>& environment,
                  JobRecord& record) {
  record.program.argv = replicas.front().argv;
  std::vector<std::string> commands;
  for (const auto& job : replicas) commands.push_back(shell_command(job.folder, environment, job.argv));
  record.program.shell = fmt::format("{}", fmt::join(commands, " && "));
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
  auto renderer = plan.renderers[planned.renderer].entry;
  renderer.limits = limits_of(plan, planned);
  Execution execution{skipped_record(plan, planned), {}};
  auto& record = execution.record;
  record.program.version = version;
  const auto prepared = scene_for(plan, planned);
  if (const auto* reason = std::get_if<std::string>(&prepared)) {
    record.end.outcome = JobOutcome::Unsupported;
    record.end.reason = *reason;
    return execution;
  }
  const auto replicas = prepare_replicas(plan, planned, std::get<scene::Scene>(prepared), folders.unfinished);
  note_command(replicas_of(plan, planned, folders.run),
               process_request(renderer, replicas.front(), stop).environment, record);
  record.cost.started = local_time_now();
  record.cost.load = load_average();
  std::optional<adapters::Isolation> isolation;
  if (plan.settings.sandbox)
    isolation = {replicas.front().folder,
                 {plan.root, plan.build, plan.renderers[planned.renderer].executable.parent_path()},
                 folders_with_references(plan, folders.run)};
  const auto came_back = plan.images.empty() ? plan.images : plan.images / planned.folder;
  if (!came_back.empty()) record.cost = {};
  auto [outcome, file] = run_replicas(replicas, renderer, came_back, isolation, stop, record);
  record.end.outcome = outcome.kind;
  record.end.reason = outcome.reason;
  if (results::leaves_visible_image(outcome.kind))
    record.files.image = (planned.folder / file.filename()).string();
  const bool keep_log = plan.settings.log || !has_image(record);
  if (keep_log) record.files.log = (planned.folder / "log.txt").string();
  std::error_code ignored;
  if (!keep_log) std::filesystem::remove(replicas.front().folder / "log.txt", ignored);
  execution.image = std::move(outcome.image);
  return execution;
}

}  // namespace orbs::run
