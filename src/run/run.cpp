#include "run/run.h"

#include "base/files.h"
#include "judge/qualified.h"
#include "judge/reference.h"
#include "registry/image_size.h"
#include "results/effect_costs.h"
#include "results/qualification.h"
#include "results/record.h"
#include "results/run_folder.h"
#include "run/execute.h"
#include "run/expected.h"
#include "run/host.h"
#include "run/judge_targets.h"
#include "run/plan/scenes.h"
#include "run/render_jobs.h"
#include "run/renderer_version.h"
#include "run/summary.h"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

namespace orbs::run {

namespace {

using results::JobRecord;
using results::TargetRecord;

// In the order of the plan, not in that in which the renders ended.
std::vector<TargetRecord> all_targets(const Plan& plan,
                                      RenderedJobs& rendered,
                                      const std::vector<JobRecord>& jobs,
                                      const WorkFolders& folders) {
  std::vector<TargetRecord> records;
  std::vector<std::size_t> taken(plan.jobs.size(), 0);
  for (std::size_t target = 0; target < plan.targets.size(); ++target) {
    const auto& planned = plan.targets[target];
    if (planned.jobs.empty()) {
      records.push_back(unsupported_target(plan, planned, folders.run));
    } else if (planned.jobs.size() == 1) {
      const auto job = planned.jobs.front();
      records.push_back(rendered.jobs[job].targets[taken[job]++]);
    } else if (const auto judged = rendered.differences.find(target); judged != rendered.differences.end()) {
      records.push_back(std::move(judged->second));
    } else {
      records.push_back(
          judge_difference(plan, planned, {&jobs[planned.jobs.front()], &jobs[planned.jobs.back()]}, folders)
              .record);
    }
  }
  return records;
}

// What is known of gates at the full size says little of those at a reduced one, so each size has its own.
std::string smallest_error(const registry::Case& one_case,
                           const Plan& plan,
                           const std::vector<results::GateRecord>& gates) {
  auto text = judge::smallest_error_seen(one_case, plan.suite.references, gates);
  if (!text.empty() && plan.settings.size_divisor != 1)
    text = fmt::format("at {}: {}", registry::size_text(plan.settings.size_divisor), text);
  return text;
}

// The cases, and one more for each accepted reference, so that it is copied as if its own scene was judged.
std::vector<registry::Case> with_accepted(std::vector<registry::Case> cases) {
  const auto count = cases.size();
  for (std::size_t i = 0; i < count; ++i)
    for (const auto& scene : cases[i].scenes)
      for (const auto& accepted : scene.accepted) {
        registry::Case other;
        other.file = cases[i].file;
        other.scenes.push_back({accepted.reference, {}});
        cases.push_back(std::move(other));
      }
  return cases;
}

// The record before anything is rendered: every image that can be rendered waits for its turn.
results::RunRecord record_at_start(const Plan& plan,
                                   const std::vector<std::string>& versions,
                                   const std::filesystem::path& folder,
                                   const RunContext& context) {
  results::RunRecord record;
  record.suite = plan.suite.name;
  record.size = registry::size_text(plan.settings.size_divisor);
  record.strict = plan.settings.strict;
  record.plan = plan.id;
  record.shard = registry::shard_text(context.file.shard);
  record.folder = folder.string();
  record.started = context.file.started;
  record.label = context.file.label;
  record.orbs_version = context.rendering.orbs_version;
  record.command_line = context.command_line;
  record.host = this_host();
  record.load = load_average();
  record.left_out = plan.left_out;
  record.finished = false;
  const auto gates =
      results::read_qualification(plan.suite.references / results::qualification_file(record.size));
  for (const auto& one_case : plan.cases)
    record.cases.push_back({plan.suite.name, one_case.name, one_case.requirement, one_case.title,
                            one_case.tests, one_case.typical_mistake, smallest_error(one_case, plan, gates)});
  const auto effect_costs_file = plan.suite.references / results::kEffectCostsFile;
  record.effect_study = results::read_effect_study(effect_costs_file);
  auto effect_costs = results::read_effect_costs(effect_costs_file);
  for (const auto& scene : plan.scenes) {
    record.scenes.push_back(scene_record(scene.name, *scene.scene));
    record.scenes.back().effect_costs = effect_costs[scene.name];
    if (scene.size_divisor != plan.settings.size_divisor)
      record.scenes.back().size = registry::size_text(scene.size_divisor);
  }
  for (const auto& job : plan.jobs) record.jobs.push_back(skipped_record(plan, job));
  for (const auto& planned : plan.targets) {
    if (planned.jobs.empty()) {
      record.targets.push_back(unsupported_target(plan, planned, folder));
    } else {
      record.targets.push_back(blank_target(plan, planned, folder));
      take_job_verdict(record.jobs[planned.jobs.front()], record.targets.back());
    }
  }
  summarise(plan, versions, record);
  return record;
}

}  // namespace

results::RunRecord run(const Plan& plan, const std::filesystem::path& folder, const RunContext& context) {
  const auto begin = std::chrono::steady_clock::now();
  const results::RunLock lock(folder);
  write_plan(context.whole_plan, folder);
  write_run_file(context.file, folder);
  const results::WorkFolder work_folder(folder);
  WorkFolders folders{folder, work_folder.path(), {}};
  folders.references =
      judge::copy_references(with_accepted(plan.cases), plan.suite.references, plan.reference_hashes,
                             folders.unfinished / kReferenceFolder, registry::reduced_size(plan.settings));
  put_in_place(folders.unfinished / kReferenceFolder, folder / kReferenceFolder);
  folders.references.folder = folder / kReferenceFolder;
  std::vector<std::string> versions;
  for (const auto& renderer : plan.renderers) {
    versions.push_back(plan.images.empty() ? renderer_version(renderer, plan, {.say = context.rendering.say})
                                           : "rendered elsewhere");
    if (versions.back().starts_with("unknown") && context.rendering.say)
      context.rendering.say(fmt::format("{}: version {}", renderer.entry.name, versions.back()));
  }
  auto record = record_at_start(plan, versions, folder, context);
  write_file(folder / "results.json", results::run_json(record));
  ProgramWatch programs(plan);
  auto rendering = context.rendering;
  rendering.day = registry::day_of(context.file.started);
  auto rendered = render_jobs(plan, versions, folders, rendering, programs);
  record.jobs.clear();
  for (auto& job : rendered.jobs) record.jobs.push_back(std::move(job.job));
  record.targets = all_targets(plan, rendered, record.jobs, folders);
  mark_expected(plan.expected, record);
  // An interrupt that came when all was done has interrupted nothing.
  record.interrupted = std::any_of(record.jobs.begin(), record.jobs.end(), [](const JobRecord& job) {
    return job.end.outcome == results::JobOutcome::Skipped || results::goes_on(job);
  });
  record.finished = true;
  summarise(plan, versions, record);
  record.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  // Before the lock is released: whoever sees that nothing runs any more must find the end of it.
  write_file(folder / "results.json", results::run_json(record));
  return record;
}

}  // namespace orbs::run
