#include "report/files.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::report {

namespace {

using results::RunRecord;
using results::TargetRecord;

// RFC 4180, section 2.
std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  return out += '"';
}

std::vector<std::string> metric_names(const RunRecord& run) {
  std::vector<std::string> names;
  for (const auto& target : run.targets)
    for (const auto& measure : target.measures)
      if (std::find(names.begin(), names.end(), measure.name) == names.end()) names.push_back(measure.name);
  return names;
}

std::string measure_text(const TargetRecord& target, const std::string& name) {
  for (const auto& measure : target.measures)
    if (measure.name == name) return std::isinf(measure.value) ? "inf" : fmt::format("{}", measure.value);
  return "";
}

// The cost of a target; that of a difference is the sum of two renders.
struct Cost {
  double wall_seconds = 0;
  double cpu_seconds = 0;
  double render_seconds = 0;
  std::size_t peak_rss_bytes = 0;
  bool is_known = false;
  bool has_render_seconds = true;
  std::string machine;  // "" if it was rendered on two kinds of machine
};

Cost cost_of(const results::JobsById& jobs, const TargetRecord& target) {
  Cost cost;
  for (const auto& id : target.jobs) {
    const auto found = jobs.find(id);
    if (found == jobs.end() || found->second->cost.started.empty()) continue;
    const auto& job = *found->second;
    const auto machine = results::timing_machine(job.cost.host);
    cost.machine = !cost.is_known || machine == cost.machine ? machine : "";
    cost.is_known = true;
    cost.wall_seconds += job.cost.wall_seconds;
    cost.cpu_seconds += job.cost.cpu_seconds;
    cost.has_render_seconds = cost.has_render_seconds && job.cost.render_seconds.has_value();
    cost.render_seconds += job.cost.render_seconds.value_or(0);
    cost.peak_rss_bytes = std::max(cost.peak_rss_bytes, job.cost.peak_rss_bytes);
  }
  return cost;
}

std::string cost_fields(const Cost& cost) {
  if (!cost.is_known) return ",,,,";
  return fmt::format("{},{:.3f},{:.3f},{},{}", csv_field(cost.machine), cost.wall_seconds, cost.cpu_seconds,
                     cost.has_render_seconds ? fmt::format("{:.3f}", cost.render_seconds) : "",
                     cost.peak_rss_bytes);
}

}  // namespace

std::string results_csv(const RunRecord& run) {
  const auto metrics = metric_names(run);
  const auto jobs = jobs_by_id(run);
  std::string text =
      "suite,size,requirement,case,target,renderer,declared,verdict,expectation,expected,reason,diagnosis,"
      "remarks";
  for (const auto& metric : metrics) text += fmt::format(",{}", metric);
  text += ",machine,wall_seconds,cpu_seconds,render_seconds,peak_rss_bytes,image,command\r\n";
  for (const auto& target : run.targets) {
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}", csv_field(run.suite), csv_field(run.size),
                        csv_field(target.requirement), csv_field(target.case_name), csv_field(target.target),
                        csv_field(target.renderer), target.declared, verdict_name(target.verdict),
                        expectation_name(target.expectation), csv_field(target.expected),
                        csv_field(led_reason(target)), csv_field(target.diagnosis),
                        csv_field(fmt::format("{}", fmt::join(target.remarks, "; "))));
    for (const auto& metric : metrics) text += fmt::format(",{}", measure_text(target, metric));
    text += fmt::format(",{},{},{}\r\n", cost_fields(cost_of(jobs, target)), csv_field(target.image),
                        csv_field(results::command_of(jobs, target)));
  }
  return text;
}

}  // namespace orbs::report
