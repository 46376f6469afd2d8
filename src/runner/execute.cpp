#include "runner/execute.h"

#include "adapters/export.h"
#include "adapters/native_scene.h"
#include "adapters/process.h"
#include "adapters/programs.h"
#include "base/error.h"
#include "base/files.h"
#include "base/shell.h"
#include "base/text.h"
#include "image/image_io.h"
#include "metrics/seeds.h"
#include "registry/placeholders.h"
#include "runner/host.h"
#include "runner/outcome.h"
#include "runner/render_seconds.h"

#include <algorithm>
#include <array>
#include <ctime>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::runner {

namespace {

using results::JobRecord;
using results::Verdict;

adapters::ProcessRequest process_request(const registry::Renderer& renderer,
                                         const adapters::Job& job,
                                         const std::atomic<bool>* stop) {
  adapters::ProcessRequest request;
  request.argv = job.argv;
  request.argv[0] = adapters::find_program(job.argv[0]).value_or(job.argv[0]).string();
  request.folder = job.folder;
  auto allowed = renderer.environment;
  allowed.push_back(fmt::format("ORBS_JOB={}", job.id));
  request.environment = adapters::child_environment(allowed);
  request.log = job.folder / "log.txt";
  request.limits = renderer.limits;
  request.stop = stop;
  return request;
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed)
    throw InputError(fmt::format("{}: the folder cannot be made: {}", folder.string(), failed.message()));
}

// The job in its folder, with the scene written there and all that will prove its picture to be its own. With
// several seeds that of the first.
adapters::Job prepare_job(const Plan& plan,
                          const PlannedJob& planned,
                          const scene::Scene& prepared,
                          const std::filesystem::path& folder) {
  auto job = job_in(plan, planned, folder);
  make_folder(job.folder);
  if (planned.native_scene.empty()) {
    adapters::export_scene(plan.renderers[planned.renderer].entry, prepared, job.scene_file);
  } else {
    adapters::copy_native_scene(planned.native_scene, job.folder);
  }
  job.id = planned.id;
  job.scene_file_hash = hash_text(content_hash(read_file(job.scene_file)));
  // By the clock of that disk, as the picture will be.
  job.ready_since = std::filesystem::last_write_time(job.scene_file);
  job.may_be_negative = planned.may_be_negative;
  return job;
}

// Adds to what the seeds before took; how it ended is its own.
void note_process(const adapters::ProcessResult& process,
                  const registry::Renderer& renderer,
                  const std::filesystem::path& folder,
                  JobRecord& record) {
  record.wall_seconds += process.wall_seconds;
  record.cpu_seconds += process.user_seconds + process.system_seconds;
  record.peak_rss_bytes = std::max(record.peak_rss_bytes, process.peak_rss_bytes);
  record.exit_code = process.exit_code;
  record.core_dumped = process.core_dumped;
  if (process.signal != 0) record.signal = adapters::signal_name(process.signal);
  if (const auto seconds = render_seconds(renderer.render_seconds, process.output, folder))
    record.render_seconds = record.render_seconds.value_or(0) + *seconds;
}

// One process for each seed, until one leaves no usable picture: record.image is then its.
Outcome run_seeds(const Plan& plan,
                  const PlannedJob& planned,
                  adapters::Job& job,
                  const std::filesystem::path& unfinished,
                  const std::atomic<bool>* stop,
                  JobRecord& record) {
  const auto& renderer = plan.renderers[planned.renderer].entry;
  std::vector<image::Image> pictures;
  for (int turn = 0; turn < renderer.seeds; ++turn) {
    const auto own = job_in(plan, planned, unfinished, turn);
    job.argv = own.argv;
    job.image = own.image;
    const auto process = adapters::run_process(process_request(renderer, job, stop));
    note_process(process, renderer, job.folder, record);
    auto outcome = classify(process, job, renderer.limits);
    if (outcome.verdict != Verdict::Pass || renderer.seeds == 1) return outcome;
    pictures.push_back(std::move(*outcome.picture));
  }
  for (int turn = 0; turn < renderer.seeds; ++turn)
    std::filesystem::remove(job_in(plan, planned, unfinished, turn).image);
  job.image = job.folder / adapters::JobSettings{}.image_file;
  auto together = metrics::are_equal(pictures) ? pictures.front() : metrics::mean_and_variance_of(pictures);
  image::write_exr(together, job.image);
  return {Verdict::Pass, "", std::move(together)};
}

// The renders of all seeds once more, in their place.
std::string command_of(const Plan& plan,
                       const PlannedJob& planned,
                       const adapters::ProcessRequest& request,
                       const std::filesystem::path& run) {
  std::vector<std::string> commands;
  for (int turn = 0; turn < plan.renderers[planned.renderer].entry.seeds; ++turn)
    commands.push_back(
        shell_command(run / planned.folder, request.environment, job_in(plan, planned, run, turn).argv));
  return fmt::format("{}", fmt::join(commands, " && "));
}

}  // namespace

std::string local_time_now() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  ::localtime_r(&now, &local);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%S", &local);
  return text.data();
}

JobRecord skipped_record(const Plan& plan, const PlannedJob& job) {
  JobRecord record;
  record.id = job.id;
  record.suite = plan.suite.name;
  record.scene = plan.scenes[job.scene].name;
  record.renderer = plan.renderers[job.renderer].entry.name;
  record.spp = job.spp;
  record.seed = plan.settings.seed;
  record.seeds = plan.renderers[job.renderer].entry.seeds;
  record.threads = plan.threads;
  record.folder = job.folder.string();
  if (!job.native_scene.empty())
    record.native_scene = job.native_scene.lexically_proximate(plan.root).string();
  record.sentence = "the run ended before its turn";
  return record;
}

Execution execute(const Plan& plan,
                  const PlannedJob& planned,
                  const std::string& version,
                  const WorkFolders& folders,
                  const std::atomic<bool>* stop) {
  const auto& renderer = plan.renderers[planned.renderer].entry;
  Execution execution{skipped_record(plan, planned), {}};
  auto& record = execution.record;
  record.renderer_version = version;
  const auto prepared = scene_for(plan, planned);
  if (const auto* reason = std::get_if<std::string>(&prepared)) {
    record.verdict = Verdict::Unsupported;
    record.sentence = *reason;
    return execution;
  }
  auto job = prepare_job(plan, planned, std::get<scene::Scene>(prepared), folders.unfinished);
  // As it can be repeated once the folder is in its place.
  record.argv = job_in(plan, planned, folders.run).argv;
  record.command = command_of(plan, planned, process_request(renderer, job, stop), folders.run);
  record.started = local_time_now();
  record.load = load_average();
  auto outcome = run_seeds(plan, planned, job, folders.unfinished, stop, record);
  record.verdict = outcome.verdict;
  record.sentence = outcome.sentence;
  record.rendered = outcome.verdict == Verdict::Pass;
  // A picture that cannot be judged can still be looked at.
  if (record.rendered || record.verdict == Verdict::InvalidPixels || record.verdict == Verdict::WrongSize ||
      record.verdict == Verdict::Stale)
    record.image = (planned.folder / job.image.filename()).string();
  const bool keep_log = plan.settings.log || !record.rendered;
  if (keep_log) record.log = (planned.folder / "log.txt").string();
  std::error_code ignored;
  if (!keep_log) std::filesystem::remove(job.folder / "log.txt", ignored);
  execution.picture = std::move(outcome.picture);
  return execution;
}

std::string renderer_version(const ChosenRenderer& renderer, const Plan& plan) {
  constexpr double kLimit_seconds = 30;
  if (renderer.entry.version_command.empty()) return "";
  adapters::ProcessRequest request;
  request.argv = registry::fill_placeholders(renderer.entry.version_command,
                                             {{"executable", renderer.executable.string()},
                                              {"root", plan.root.string()},
                                              {"build", plan.build.string()}});
  const auto program = adapters::find_program(request.argv[0]);
  if (!program) return fmt::format("unknown: there is no program '{}'", request.argv[0]);
  request.argv[0] = program->string();
  request.environment = adapters::child_environment(renderer.entry.environment);
  request.limits.wall_seconds = kLimit_seconds;
  const auto process = adapters::run_process(request);
  if (process.cause == warden::Cause::WallTime)
    return fmt::format("unknown: '{}' did not end within {} s", request.argv[0], kLimit_seconds);
  for (const auto& line : split(process.output, '\n'))
    if (const auto text = trim(line); !text.empty() && text.starts_with(renderer.entry.version_prefix))
      return std::string(text);
  return renderer.entry.version_prefix.empty()
             ? "unknown: its version command prints nothing"
             : fmt::format("unknown: its version command prints no line that starts '{}'",
                           renderer.entry.version_prefix);
}

}  // namespace orbs::runner
