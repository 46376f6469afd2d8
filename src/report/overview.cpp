#include "report/overview.h"

#include "base/shell.h"
#include "json/writer.h"
#include "results/field_writer.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <vector>

namespace orbs::report {

namespace {

using json::Writer;
using results::JobState;
using results::RunRecord;
using results::RunView;
using results::TargetRecord;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();  // null in JSON

// A list of names without repetitions, and the index of each.
struct Names {
  std::vector<std::string> list;
  std::map<std::string, std::size_t> index;

  double of(const std::string& name) {
    const auto [at, is_new] = index.try_emplace(name, list.size());
    if (is_new) list.push_back(name);
    return static_cast<double>(at->second);
  }
};

// States of a cell whose render waits or runs. They follow the verdicts in the list of states.
constexpr std::string_view kWaiting = "waiting";
constexpr std::string_view kRunning = "running";

// Behind these two: known failures, then unexpected passes.
constexpr auto kKnownState = static_cast<double>(results::kVerdicts.size() + 2);

double state_of(const TargetRecord& target,
                const RunView& view,
                const std::map<std::string, std::size_t>& jobs) {
  bool is_waiting = false;
  bool is_running = false;
  for (const auto& id : target.jobs) {
    const auto job = jobs.find(id);
    if (!view.is_live || job == jobs.end()) continue;
    is_waiting = is_waiting || view.states[job->second] == JobState::Waiting;
    is_running = is_running || view.states[job->second] == JobState::Running;
  }
  // A difference of two renders is judged when the run ends.
  is_waiting = is_waiting || (view.is_live && target.jobs.size() > 1);
  if (is_running) return static_cast<double>(results::kVerdicts.size() + 1);
  if (is_waiting) return static_cast<double>(results::kVerdicts.size());
  const auto state = state_name(target);
  if (state == results::kKnown) return kKnownState;
  if (state == results::kUnexpectedPass) return kKnownState + 1;
  const auto at = std::find(results::kVerdicts.begin(), results::kVerdicts.end(), target.verdict);
  return static_cast<double>(at - results::kVerdicts.begin());
}

struct Columns {
  Names cases, targets, renderers, reasons, machines;
  std::map<std::string, std::vector<double>> cells;
  std::map<std::string, std::vector<double>> measures;
  std::map<std::string, std::vector<double>> infinite;
  std::vector<const results::Measure*> metrics;  // each name once
};

// The image of a difference costs the sum of two renders, and the larger of the two memories. It has a
// machine if both were rendered on the same kind.
void add_cost(const TargetRecord& target,
              const RunRecord& run,
              const std::map<std::string, std::size_t>& jobs,
              Columns& columns) {
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
  columns.cells["machine"].push_back(one_machine ? columns.machines.of(machines.front()) : kNone);
  columns.cells["wall_seconds"].push_back(wall);
  columns.cells["cpu_seconds"].push_back(cpu);
  columns.cells["render_seconds"].push_back(own);
  columns.cells["peak_rss_bytes"].push_back(memory);
  columns.cells["spp"].push_back(spp);
}

void add_measures(const TargetRecord& target, std::size_t index, Columns& columns) {
  for (const auto& measure : target.measures) {
    auto& column = columns.measures[measure.name];
    if (column.empty()) columns.metrics.push_back(&measure);
    column.resize(index, kNone);
    column.push_back(measure.value);
    if (std::isinf(measure.value)) columns.infinite[measure.name].push_back(static_cast<double>(index));
  }
}

Columns columns_of(const RunView& view) {
  const auto& run = view.run;
  Columns columns;
  std::map<std::string, std::size_t> jobs;
  for (std::size_t i = 0; i < run.jobs.size(); ++i) jobs[run.jobs[i].identity.id] = i;
  for (const auto& one_case : run.cases) columns.cases.of(one_case.name);
  for (const auto& renderer : run.renderers) columns.renderers.of(renderer.name);
  std::error_code ignored;
  for (std::size_t i = 0; i < run.targets.size(); ++i) {
    const auto& target = run.targets[i];
    columns.cells["case"].push_back(columns.cases.of(target.case_name));
    columns.cells["target"].push_back(columns.targets.of(target.target));
    columns.cells["renderer"].push_back(columns.renderers.of(target.renderer));
    columns.cells["state"].push_back(state_of(target, view, jobs));
    columns.cells["declared"].push_back(target.declared ? 1 : 0);
    columns.cells["reason"].push_back(columns.reasons.of(reason_text(target)));
    const auto folder = std::filesystem::path(run.folder) / target.image;
    columns.cells["thumbnail"].push_back(
        !target.image.empty() && std::filesystem::exists(folder.parent_path() / "result.png", ignored) ? 1
                                                                                                       : 0);
    add_cost(target, run, jobs, columns);
    add_measures(target, i, columns);
  }
  return columns;
}

void write_columns(Writer& out,
                   std::string_view key,
                   const std::map<std::string, std::vector<double>>& columns) {
  out.key(key).begin_object();
  for (const auto& [name, values] : columns) out.key(name).numbers(values);
  out.end_object();
}

void write_run(Writer& out, const RunView& view) {
  const auto& run = view.run;
  out.key("run").begin_object();
  out.member("name", run.name).member("suite", run.suite);
  out.member("size", run.size);
  out.member("started", run.started).member("wall_seconds", run.wall_seconds);
  out.member("orbs_version", run.orbs_version).member("command", shell_text(run.command_line));
  out.member("interrupted", run.interrupted).member("finished", run.finished).member("live", view.is_live);
  out.member("load", run.load).key("host");
  results::write_record(out, run.host);
  out.end_object();
}

void write_states(Writer& out) {
  out.key("states").begin_array();
  for (const auto verdict : results::kVerdicts)
    out.begin_object()
        .member("name", results::verdict_name(verdict))
        .member("failure", results::counts_as_failure(verdict))
        .end_object();
  for (const auto name : {kWaiting, kRunning})
    out.begin_object().member("name", name).member("failure", false).end_object();
  out.begin_object().member("name", results::kKnown).member("failure", false).end_object();
  out.begin_object().member("name", results::kUnexpectedPass).member("failure", true).end_object();
  out.end_array();
}

void write_cases(Writer& out, const RunRecord& run, const Names& names) {
  out.key("cases").begin_array();
  for (const auto& name : names.list) {
    const auto found =
        std::find_if(run.cases.begin(), run.cases.end(), [&](const auto& c) { return c.name == name; });
    // Without "cases" in results.json, only the targets say something about a case.
    const auto first = std::find_if(run.targets.begin(), run.targets.end(),
                                    [&](const auto& p) { return p.case_name == name; });
    const bool known = found != run.cases.end();
    out.begin_object().member("name", name).member("suite", known ? found->suite : run.suite);
    out.member("requirement", known ? found->requirement : first->requirement);
    out.member("title", known ? found->title : name).member("tests", known ? found->tests : "");
    out.member("typical_mistake", known ? found->typical_mistake : "");
    if (known && !found->smallest_error_seen.empty())
      out.member("smallest_error_seen", found->smallest_error_seen);
    out.end_object();
  }
  out.end_array();
}

// Counts each render once, even if several cases and differences use it.
void write_costs(Writer& out, const RunRecord& run, const std::string& renderer) {
  double wall_seconds = 0;
  double cpu_seconds = 0;
  std::size_t peak_rss_bytes = 0;
  for (const auto& job : run.jobs) {
    if (job.identity.renderer != renderer) continue;
    wall_seconds += job.cost.wall_seconds;
    cpu_seconds += job.cost.cpu_seconds;
    peak_rss_bytes = std::max(peak_rss_bytes, job.cost.peak_rss_bytes);
  }
  out.member("wall_seconds", wall_seconds).member("cpu_seconds", cpu_seconds);
  out.member("peak_rss_bytes", static_cast<unsigned long long>(peak_rss_bytes));
}

void write_renderers(Writer& out, const RunRecord& run, const Names& names) {
  out.key("renderers").begin_array();
  for (const auto& name : names.list) {
    const auto found = std::find_if(run.renderers.begin(), run.renderers.end(),
                                    [&](const auto& renderer) { return renderer.name == name; });
    out.begin_object().member("name", name);
    write_costs(out, run, name);
    if (found != run.renderers.end())
      out.member("version", found->version)
          .member("declared", found->declared)
          .member("measured", found->measured);
    out.end_object();
  }
  out.end_array().key("left_out").begin_array();
  for (const auto& left : run.left_out) results::write_record(out, left);
  out.end_array();
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

std::string overview_json(const RunView& view) {
  const auto& run = view.run;
  auto columns = columns_of(view);
  Writer out;
  out.begin_object().member("format", "orbs-page/2");
  write_run(out, view);
  write_states(out);
  write_renderers(out, run, columns.renderers);
  write_cases(out, run, columns.cases);
  out.key("requirements").begin_array();
  for (const auto& requirement : run.requirements)
    out.begin_object().member("code", requirement.code).member("title", requirement.title).end_object();
  out.end_array().key("metrics").begin_array();
  for (const auto* metric : columns.metrics)
    out.begin_object()
        .member("name", metric->name)
        .member("unit", metric->unit)
        .member("definition", metric->definition)
        .member("lower_is_better", metric->lower_is_better)
        .member("signed", metric->is_signed)
        .end_object();
  out.end_array();
  out.member("main_metric", main_metric(run));
  out.member("targets", columns.targets.list).member("reasons", columns.reasons.list);
  out.member("machines", columns.machines.list);
  for (auto& [name, values] : columns.measures) values.resize(run.targets.size(), kNone);
  write_columns(out, "cells", columns.cells);
  write_columns(out, "measures", columns.measures);
  write_columns(out, "infinite", columns.infinite);
  return out.end_object().text();
}

}  // namespace orbs::report
