#include "page/fixture_records.h"

#include "base/files.h"
#include "registry/features.h"

#include <cctype>

#include <fmt/format.h>

namespace orbs::page_tests {

namespace {

results::Host the_host() {
  results::Host host;
  host.name = "host";
  host.cpu = "a processor";
  host.cores = 2;
  host.system = "Linux";
  return host;
}

}  // namespace

results::JobRecord job_of(const std::string& scene, const std::string& renderer, double seconds) {
  results::JobRecord job;
  job.identity.id = hash_text(content_hash(scene + "\n" + renderer));
  job.identity.suite = "alpha";
  job.identity.scene = scene;
  job.identity.renderer = renderer;
  job.program.version = renderer + " 1.0";
  job.program.argv = {"/opt/" + renderer, "scene.json", "with space", "it's"};
  job.files.folder = renderer + "/" + scene;
  job.identity.spp = 16;
  job.identity.seed = 1;
  job.program.threads = 2;
  job.cost.host = the_host();
  job.cost.started = "2026-01-02T03:04:05";
  job.cost.wall_seconds = seconds;
  job.cost.cpu_seconds = 2 * seconds;
  job.cost.render_seconds = seconds / 2;
  job.cost.peak_rss_bytes = 123'000'000;
  job.end.outcome = results::JobOutcome::Image;
  return job;
}

results::TargetRecord target_of(const std::string& case_name,
                                const results::JobRecord& job,
                                results::Verdict verdict) {
  results::TargetRecord target;
  target.requirement = {static_cast<char>(std::toupper(case_name[0])), case_name[1]};
  target.case_name = case_name;
  target.target = job.identity.scene;
  target.renderer = job.identity.renderer;
  target.jobs = {job.identity.id};
  target.declared = true;
  target.verdict = verdict;
  target.reason = fmt::format("psnr_srgb8 is told for {}", verdict_name(verdict));
  const double psnr = verdict == results::Verdict::Pass ? 41.5 : 20.25;
  target.measures = {{"l1", 0.01 * job.cost.wall_seconds, "radiance", "mean of |result - reference|", true},
                     {"psnr_srgb8", psnr, "dB", "10 log10(255^2 / MSE)", false},
                     {"lean", -0.0125, "1", "how far it leans", true, true, -0.02, -0.005, {8, 16, 24, 32}}};
  target.remarks = {"it leans to the left"};
  target.checks = {{"psnr_srgb8", verdict == results::Verdict::Pass, target.reason, 35.0, {}}};
  return target;
}

results::CaseRecord case_of(const std::string& suite, const std::string& name, const std::string& title) {
  const std::string requirement{static_cast<char>(std::toupper(name[0])), name[1]};
  return {suite, name, requirement, title, "What " + title + " tests.", "What goes wrong in " + title + "."};
}

results::RunRecord blank_run(const std::vector<std::string>& renderers) {
  results::RunRecord run;
  run.suite = "alpha";
  run.started = "2026-01-02T03:04:05";
  run.wall_seconds = 12.5;
  run.orbs_version = "0.0";
  run.command_line = {"orbs", "run", "--spp-scale", "0.5"};
  run.host = the_host();
  run.load = 0.25;
  for (const auto& name : renderers) {
    results::RendererRecord renderer;
    renderer.name = name;
    renderer.version = name + " 1.0";
    renderer.declared = "G5/M8/L4/A4";
    renderer.measured = "G0/M1/L0/A0";
    run.renderers.push_back(renderer);
  }
  return run;
}

void write_run(results::RunRecord run, const std::filesystem::path& folder) {
  for (const auto& one_case : run.cases)
    run.requirements.push_back({one_case.requirement,
                                one_case.title,
                                {},
                                std::string(registry::what_of_group(one_case.requirement.front()))});
  run.folder = folder.string();
  write_file(folder / "results.json", results::run_json(run));
}

}  // namespace orbs::page_tests
