#include "run/render_once.h"

#include "adapters/export.h"
#include "adapters/process/process.h"
#include "adapters/process/programs.h"
#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "json/document.h"
#include "json/object_reader.h"
#include "run/job_folder.h"
#include "run/outcome.h"
#include "run/plan/render_seconds.h"

#include <fmt/format.h>

namespace orbs::run {

namespace {

struct TracerReport {
  std::optional<double> traversal_share;
  std::optional<double> samples_cpu_seconds;
};

// From the last line of the tracer's --json report. It clocks traversal by the wall in each thread, so the
// whole is the wall clock of all threads: on a machine that others use, CPU time would be less than the part.
TracerReport read_report(const std::string& output, int threads) {
  for (const auto& line : split(output, '\n')) {
    if (!line.starts_with('{') || line.find("\"traversal_seconds\"") == std::string::npos) continue;
    const auto document = json::parse("the report of orbs-tracer", line);
    json::ObjectReader report(document);
    TracerReport found;
    found.samples_cpu_seconds = report.number("cpu_seconds", json::kNotNegative);
    const double whole = report.number("render_seconds", json::kNotNegative) * threads;
    if (whole > 0) found.traversal_share = report.number("traversal_seconds", json::kNotNegative) / whole;
    return found;
  }
  return {};
}

}  // namespace

PreparedRender prepare_render(const ChosenRenderer& renderer,
                              const Plan& plan,
                              const scene::Scene& scene,
                              const std::filesystem::path& folder) {
  const auto prepared = adapters::prepare_scene(renderer.entry, scene);
  if (const auto* reason = std::get_if<std::string>(&prepared))
    throw InputError(fmt::format("renderer '{}' cannot render the scene: {}", renderer.entry.name, *reason));
  PreparedRender subject{renderer, scene, {}, folder, false};
  subject.settings.root = plan.root;
  subject.settings.build = plan.build;
  subject.settings.executable = renderer.executable;
  std::error_code ignored;
  subject.is_built_in = std::filesystem::equivalent(renderer.executable, plan.build / "orbs-tracer", ignored);
  make_folder(folder);
  const auto job = adapters::make_job(renderer.entry, scene, subject.settings, folder);
  adapters::export_scene(renderer.entry, std::get<scene::Scene>(prepared), job.scene_file);
  return subject;
}

std::optional<RenderedImage> render_once(const PreparedRender& prepared,
                                         const RenderSettings& settings,
                                         const std::atomic<bool>* stop) {
  const auto& entry = prepared.renderer.entry;
  auto job_settings = prepared.settings;
  job_settings.spp = settings.spp;
  job_settings.seed = settings.seed;
  job_settings.threads = settings.threads;
  auto job = adapters::make_job(entry, prepared.scene, job_settings, prepared.folder);
  job.may_be_negative = settings.may_be_negative;
  make_way(job.image);
  forget_render_seconds(entry.timing.render_seconds, job.folder);
  adapters::ProcessRequest request;
  request.argv = job.argv;
  request.argv[0] = adapters::find_program(job.argv[0]).value_or(job.argv[0]).string();
  if (prepared.is_built_in) request.argv.emplace_back("--json");
  for (const auto& argument : settings.more_arguments) request.argv.push_back(argument);
  request.folder = job.folder;
  request.environment = adapters::child_environment(entry.command.environment);
  request.limits = entry.limits;
  request.stop = stop;
  const auto process = adapters::run_process(request);
  if (process.cause == supervisor::Cause::Stopped) return std::nullopt;
  auto outcome = classify(process, job, entry.limits);
  if (!outcome.image)
    throw InputError(fmt::format("renderer '{}' {}; {}", entry.name, outcome.reason,
                                 process.output.empty() ? "it said nothing" : "it said:\n" + process.output));
  RenderedImage made;
  const auto report = prepared.is_built_in ? read_report(process.output, settings.threads) : TracerReport{};
  made.cost = {settings.spp,
               process.user_seconds + process.system_seconds,
               process.wall_seconds,
               process.supervisor_cpu_seconds,
               report.traversal_share,
               report.samples_cpu_seconds,
               render_seconds(entry.timing.render_seconds, process.output, job.folder)};
  made.image = std::move(*outcome.image);
  return made;
}

}  // namespace orbs::run
