#include "run/render_once.h"

#include "adapters/export.h"
#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "json/document.h"
#include "json/object_reader.h"
#include "run/job_folder.h"
#include "run/prepare.h"
#include "run/render.h"

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
                              const std::filesystem::path& folder,
                              double case_seconds) {
  const auto prepared = adapters::prepare_scene(renderer.entry, scene);
  if (const auto* reason = std::get_if<std::string>(&prepared))
    throw InputError(fmt::format("renderer '{}' cannot render the scene: {}", renderer.entry.name, *reason));
  PreparedRender subject{renderer, scene, {}, folder};
  subject.renderer.entry.limits = limits_of(renderer.entry, case_seconds);
  subject.settings.root = plan.root;
  subject.settings.build = plan.build;
  subject.settings.executable = renderer.executable;
  std::error_code ignored;
  subject.is_built_in = std::filesystem::equivalent(renderer.executable, plan.build / "orbs-tracer", ignored);
  make_folder(folder);
  if (plan.settings.sandbox) subject.isolation = isolation_of(plan, renderer, folder, folder.parent_path());
  const auto job = adapters::make_job(renderer.entry, scene, subject.settings, folder);
  adapters::export_scene(renderer.entry, std::get<scene::Scene>(prepared), job.scene_file);
  return subject;
}

namespace {

RenderJob job_of(const PreparedRender& prepared, const RenderSettings& settings) {
  const auto& entry = prepared.renderer.entry;
  auto of_job = prepared.settings;
  of_job.spp = settings.spp;
  of_job.seed = (settings.seed - 1) * entry.sampling.seeds + 1;
  of_job.threads = settings.threads;
  RenderJob job{entry, replicas_of(entry, prepared.scene, of_job, prepared.folder), prepared.isolation};
  make_way(prepared.folder / "log.txt");
  for (auto& replica : job.replicas) {
    replica.may_be_negative = settings.may_be_negative;
    make_way(replica.image);
    if (prepared.is_built_in) replica.argv.emplace_back("--json");
    replica.argv.insert(replica.argv.end(), settings.more_arguments.begin(), settings.more_arguments.end());
  }
  return job;
}

RenderCost cost_of(const PreparedRender& prepared, const RenderSettings& settings, const Rendered& rendered) {
  RenderCost cost;
  cost.spp = settings.spp;
  for (const auto& process : rendered.processes) {
    cost.cpu_seconds += process.user_seconds + process.system_seconds;
    cost.wall_seconds += process.wall_seconds;
    cost.supervisor_cpu_seconds += process.supervisor_cpu_seconds;
    if (!prepared.is_built_in) continue;
    const auto report = read_report(process.output, settings.threads);
    cost.traversal_share = report.traversal_share;
    if (report.samples_cpu_seconds)
      cost.samples_cpu_seconds = cost.samples_cpu_seconds.value_or(0) + *report.samples_cpu_seconds;
  }
  cost.render_seconds = rendered.render_seconds;
  return cost;
}

}  // namespace

std::optional<RenderedImage> render_once(const PreparedRender& prepared,
                                         const RenderSettings& settings,
                                         const std::atomic<bool>* stop) {
  auto rendered = render(job_of(prepared, settings), stop);
  if (rendered.outcome.kind == results::JobOutcome::Skipped) return std::nullopt;
  const auto& output = rendered.processes.back().output;
  if (!rendered.outcome.image)
    throw InputError(fmt::format("renderer '{}' {}; {}", prepared.renderer.entry.name,
                                 rendered.outcome.reason,
                                 output.empty() ? "it said nothing" : "it said:\n" + output));
  return RenderedImage{cost_of(prepared, settings, rendered), std::move(*rendered.outcome.image)};
}

}  // namespace orbs::run
