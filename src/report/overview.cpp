#include "report/overview.h"

#include "base/text.h"
#include "json/field_writer.h"
#include "json/writer.h"
#include "report/table.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace orbs::report {

namespace {

using results::JobState;
using results::RunRecord;
using results::RunView;
using results::TargetRecord;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();  // null in JSON

// A list of names without repetitions, and the index of each.
struct Names {
  std::vector<std::string>& list;
  std::map<std::string, std::size_t> index = {};

  std::size_t of(const std::string& name) {
    const auto [at, is_new] = index.try_emplace(name, list.size());
    if (is_new) list.push_back(name);
    return at->second;
  }
};

// States of a cell whose render waits or runs. They follow the verdicts in the list of states.
constexpr std::size_t kWaiting = results::kVerdicts.size();
constexpr std::size_t kRunning = kWaiting + 1;
constexpr std::size_t kKnownFailure = kWaiting + 2;
constexpr std::size_t kUnexpectedPass = kWaiting + 3;

// A pass with remarks is a failure of a strict run only.
std::vector<State> all_states(bool is_strict) {
  std::vector<State> states;
  for (const auto verdict : results::kVerdicts)
    states.push_back(
        {results::verdict_name(verdict),
         results::counts_as_failure(verdict) || (is_strict && verdict == results::Verdict::PassWithRemarks)});
  states.insert(
      states.end(),
      {{"waiting", false}, {"running", false}, {results::kKnown, false}, {results::kUnexpectedPass, true}});
  return states;
}

std::size_t state_of(const TargetRecord& target,
                     const RunView& view,
                     const std::map<std::string, std::size_t>& jobs) {
  bool is_waiting = false;
  bool is_running = false;
  for (const auto& id : target.jobs) {
    const auto job = jobs.find(id);
    if (!view.is_live || job == jobs.end() || goes_on(view.run.jobs[job->second])) continue;
    is_waiting = is_waiting || view.states[job->second] == JobState::Waiting;
    is_running = is_running || view.states[job->second] == JobState::Running;
  }
  // A difference of two renders is judged when the run ends.
  is_waiting = is_waiting || (view.is_live && target.jobs.size() > 1);
  if (is_running) return kRunning;
  if (is_waiting) return kWaiting;
  const auto state = state_name(target);
  if (state == results::kKnown) return kKnownFailure;
  if (state == results::kUnexpectedPass) return kUnexpectedPass;
  const auto* const at = std::find(results::kVerdicts.begin(), results::kVerdicts.end(), target.verdict);
  return static_cast<std::size_t>(at - results::kVerdicts.begin());
}

// Whether the state is the verdict of a look, after which more may follow.
bool is_preliminary(const TargetRecord& target,
                    const RunView& view,
                    const std::map<std::string, std::size_t>& jobs) {
  if (!view.is_live || target.jobs.size() != 1) return false;
  const auto job = jobs.find(target.jobs.front());
  return job != jobs.end() && goes_on(view.run.jobs[job->second]);
}

// The image of a difference costs the sum of two renders, and the larger of the two memories. It has a
// machine if both were rendered on the same kind.
void add_cost(const TargetRecord& target,
              const RunRecord& run,
              const std::map<std::string, std::size_t>& jobs,
              Names& names,
              Cells& cells) {
  double wall = kNone;
  double cpu = kNone;
  double own = kNone;
  double memory = kNone;
  double spp = kNone;
  std::vector<std::string> machines;
  const auto add = [](double& sum, double value) { sum = std::isnan(sum) ? value : sum + value; };
  for (const auto& id : target.jobs) {
    const auto found = jobs.find(id);
    if (found == jobs.end() || run.jobs[found->second].cost.started.empty()) continue;
    const auto& job = run.jobs[found->second];
    add(wall, job.cost.wall_seconds);
    add(cpu, job.cost.cpu_seconds);
    if (job.cost.render_seconds) add(own, *job.cost.render_seconds);
    memory = std::fmax(memory, static_cast<double>(job.cost.peak_rss_bytes));
    spp = job.identity.spp;
    machines.push_back(results::timing_machine(job.cost.host));
  }
  const bool one_machine =
      !machines.empty() && !machines.front().empty() && machines.front() == machines.back();
  cells.machine.push_back(one_machine ? static_cast<double>(names.of(machines.front())) : kNone);
  cells.wall_seconds.push_back(wall);
  cells.cpu_seconds.push_back(cpu);
  cells.render_seconds.push_back(own);
  cells.peak_rss_bytes.push_back(memory);
  cells.spp.push_back(spp);
}

void add_measures(const TargetRecord& target, std::size_t index, Overview& overview) {
  for (const auto& measure : target.measures) {
    const double value = measure.value;
    auto& column = overview.measures[measure.name];
    if (column.empty())
      overview.metrics.push_back(
          {measure.name, measure.unit, measure.definition, measure.lower_is_better, measure.is_signed});
    column.resize(index, kNone);
    column.push_back(value);
    if (std::isinf(value)) overview.infinite[measure.name].push_back(index);
  }
}

// Fills the cells, and the lists of names that they point into.
void add_cells(const RunView& view, Overview& overview, Names& cases, Names& renderers) {
  const auto& run = view.run;
  auto& cells = overview.cells;
  Names targets{overview.targets};
  Names reasons{overview.reasons};
  Names machines{overview.machines};
  Names texts_beside{overview.texts_beside_psnr};
  texts_beside.of("");  // most cells have none
  std::map<std::string, std::size_t> jobs;
  for (std::size_t i = 0; i < run.jobs.size(); ++i) jobs[run.jobs[i].identity.id] = i;
  for (const auto& one_case : run.cases) cases.of(one_case.name);
  for (const auto& renderer : run.renderers) renderers.of(renderer.name);
  std::error_code ignored;
  for (std::size_t i = 0; i < run.targets.size(); ++i) {
    const auto& target = run.targets[i];
    cells.cases.push_back(cases.of(target.case_name));
    cells.targets.push_back(targets.of(target.target));
    cells.renderers.push_back(renderers.of(target.renderer));
    cells.states.push_back(state_of(target, view, jobs));
    cells.preliminary.push_back(is_preliminary(target, view, jobs) ? 1 : 0);
    cells.declared.push_back(target.declared ? 1 : 0);
    // That the run ended before its turn is not true yet of what waits.
    const bool is_open = cells.states.back() == kWaiting || cells.states.back() == kRunning;
    cells.reasons.push_back(reasons.of(is_open ? "" : reason_text(target)));
    const auto image = std::filesystem::path(run.folder) / target.image;
    const bool has_thumbnail =
        !target.image.empty() && std::filesystem::exists(image.parent_path() / "result.png", ignored);
    cells.thumbnails.push_back(has_thumbnail ? 1 : 0);
    add_cost(target, run, jobs, machines, cells);
    const auto without_noise = deciding_psnr_without_noise_db(target);
    cells.beside_psnr.push_back(without_noise ? texts_beside.of(without_noise_text(*without_noise)) : 0);
    add_measures(target, i, overview);
  }
  if (overview.texts_beside_psnr.size() > 1) overview.rule_beside_psnr = kWithoutNoiseRule;
  for (auto& [name, column] : overview.measures) column.resize(run.targets.size(), kNone);
}

RunInfo info_of(const RunView& view) {
  const auto& run = view.run;
  return {run.name,
          run.suite,
          run.size,
          run.started,
          run.wall_seconds,
          run.orbs_version,
          shell_text(run.command_line),
          run.interrupted,
          run.finished,
          view.is_live,
          run.load,
          results::references_note(run),
          run.host};
}

// Without "cases" in results.json, only the targets say something about a case.
results::CaseRecord case_of(const RunRecord& run, const std::string& name) {
  for (const auto& one : run.cases)
    if (one.name == name) return one;
  const auto first = std::find_if(run.targets.begin(), run.targets.end(),
                                  [&](const auto& target) { return target.case_name == name; });
  return {run.suite, name, first->requirement, name, "", ""};
}

// Counts each render once, even if several cases and differences use it.
Renderer renderer_of(const RunRecord& run, const std::string& name) {
  Renderer out;
  out.name = name;
  for (const auto& job : run.jobs) {
    if (job.identity.renderer != name) continue;
    out.wall_seconds += job.cost.wall_seconds;
    out.cpu_seconds += job.cost.cpu_seconds;
    out.peak_rss_bytes = std::max(out.peak_rss_bytes, job.cost.peak_rss_bytes);
  }
  for (const auto& known : run.renderers) {
    if (known.name != name) continue;
    out.version = known.version;
    out.declared = known.declared;
    out.measured = known.measured;
  }
  return out;
}

bool is_measured(const TargetRecord& target, const results::Check& check) {
  return std::any_of(target.measures.begin(), target.measures.end(),
                     [&](const auto& measure) { return measure.name == check.what; });
}

// The metric of most gates, the first by name among equals; "" if there is none. The first check of a target
// that is on a number is its own gate; the checks after it are the same for all targets.
std::string main_metric(const RunRecord& run) {
  std::map<std::string, int> counts;
  for (const auto& target : run.targets) {
    const auto gate = std::find_if(target.checks.begin(), target.checks.end(),
                                   [&](const auto& check) { return is_measured(target, check); });
    if (gate != target.checks.end()) ++counts[gate->what];
  }
  const auto most = std::max_element(counts.begin(), counts.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == counts.end() ? "" : most->first;
}

}  // namespace

Overview overview_of(const RunView& view) {
  const auto& run = view.run;
  Overview overview;
  std::vector<std::string> case_names;
  std::vector<std::string> renderer_names;
  Names cases{case_names};
  Names renderers{renderer_names};
  add_cells(view, overview, cases, renderers);
  overview.run = info_of(view);
  overview.states = all_states(run.strict);
  for (const auto& name : renderer_names) overview.renderers.push_back(renderer_of(run, name));
  overview.cards = report_cards(run);
  overview.left_out = run.left_out;
  for (const auto& name : case_names) overview.cases.push_back(case_of(run, name));
  for (const auto& requirement : run.requirements)
    overview.requirements.push_back({requirement.code, requirement.title, requirement.group});
  overview.main_metric = main_metric(run);
  overview.scenes = scene_effects(run);
  overview.effect_study = run.effect_study;
  return overview;
}

std::string overview_json(const RunView& view) {
  json::Writer out;
  out.begin_object().member("format", "orbs-page/2");
  json::write_fields(out, overview_of(view));
  return out.end_object().text();
}

}  // namespace orbs::report
