#include "report/files.h"

#include "base/text.h"
#include "report/table.h"

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
                        csv_field(target.reason), csv_field(target.diagnosis),
                        csv_field(fmt::format("{}", fmt::join(target.remarks, "; "))));
    for (const auto& metric : metrics) text += fmt::format(",{}", measure_text(target, metric));
    text += fmt::format(",{},{},{}\r\n", cost_fields(cost_of(jobs, target)), csv_field(target.image),
                        csv_field(results::command_of(jobs, target)));
  }
  return text;
}

namespace {

using results::Cell;
using results::RequirementRecord;
using results::RunRecord;
using results::Verdict;

enum class Element { None, Failure, Error, Skipped };

Element element_of(const Cell& cell) {
  if (cell.expectation == results::Expectation::Known) return Element::Skipped;
  if (state_name(cell.verdict, cell.expectation) == results::kUnexpectedPass) return Element::Failure;
  switch (cell.verdict) {
    case Verdict::Pass:
      return Element::None;
    case Verdict::Unsupported:
    case Verdict::Skipped:
      return Element::Skipped;
    case Verdict::Inconclusive:
    case Verdict::MissingReference:
    case Verdict::Fail:
    case Verdict::ConstantImage:
    case Verdict::InvalidPixels:
    case Verdict::WrongChannels:
    case Verdict::WrongSize:
      return Element::Failure;
    case Verdict::Stale:
    case Verdict::Unreadable:
    case Verdict::NoOutput:
    case Verdict::Timeout:
    case Verdict::OutOfMemory:
    case Verdict::Crash:
      return Element::Error;
  }
  return Element::Error;
}

std::string verdict_element(const Cell& cell) {
  const auto message =
      xml_text(fmt::format("{}: {}", state_name(cell.verdict, cell.expectation), cell.reason));
  switch (element_of(cell)) {
    case Element::None:
      return "";
    case Element::Failure:
      return fmt::format("      <failure message=\"{}\"/>\n", message);
    case Element::Error:
      return fmt::format("      <error message=\"{}\"/>\n", message);
    case Element::Skipped:
      return fmt::format("      <skipped message=\"{}\"/>\n", message);
  }
  return "";
}

double seconds_of(const RunRecord& run,
                  const results::JobsById& jobs,
                  const std::string& requirement,
                  const std::string& renderer) {
  double seconds = 0;
  for (const auto& target : run.targets)
    if (target.requirement == requirement && target.renderer == renderer && target.jobs.size() == 1)
      if (const auto job = jobs.find(target.jobs.front()); job != jobs.end())
        seconds += job->second->cost.wall_seconds;
  return seconds;
}

std::string details(const RunRecord& run,
                    const results::JobsById& jobs,
                    const std::string& requirement,
                    const std::string& renderer) {
  std::string text;
  for (const auto& target : run.targets)
    if (target.requirement == requirement && target.renderer == renderer) {
      text += fmt::format("{}: {}: {}\n  {}\n", target.target, state_name(target), reason_text(target),
                          results::command_of(jobs, target));
      if (!target.diagnosis.empty()) text += fmt::format("{}: {}\n", target.target, target.diagnosis);
      for (const auto& remark : target.remarks) text += fmt::format("{}: {}\n", target.target, remark);
    }
  return text;
}

std::string test_case(const RunRecord& run,
                      const results::JobsById& jobs,
                      const RequirementRecord& requirement,
                      const std::string& renderer,
                      const Cell& cell) {
  auto text =
      fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\">\n",
                  xml_text(run.suite + "." + renderer), xml_text(requirement.code + " " + requirement.title),
                  seconds_of(run, jobs, requirement.code, renderer));
  text +=
      fmt::format("      <properties><property name=\"lowest_psnr_srgb8_db\" value=\"{}\"/></properties>\n",
                  decibels(cell.lowest_psnr_db));
  text += verdict_element(cell);
  text += fmt::format("      <system-out>{}</system-out>\n    </testcase>\n",
                      xml_text(details(run, jobs, requirement.code, renderer)));
  return text;
}

std::string test_suite(const RunRecord& run,
                       const results::JobsById& jobs,
                       const results::RendererRecord& renderer) {
  std::map<Element, int> counts;
  int tests = 0;
  std::string cases;
  for (const auto& requirement : run.requirements) {
    const auto cell = requirement.cells.find(renderer.name);
    if (cell == requirement.cells.end()) continue;
    ++tests;
    ++counts[element_of(cell->second)];
    cases += test_case(run, jobs, requirement, renderer.name, cell->second);
  }
  return fmt::format(
      "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" "
      "time=\"{:.3f}\" timestamp=\"{}\">\n"
      "{}  </testsuite>\n",
      xml_text(run.suite + "." + renderer.name), tests, counts[Element::Failure], counts[Element::Error],
      counts[Element::Skipped], renderer.wall_seconds, xml_text(run.started), cases);
}

}  // namespace

std::string xml_text(std::string_view text) {
  std::string out;
  for (const char c : clean_text(text)) {
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '"') {
      out += "&quot;";
    } else if (c == '\'') {
      out += "&apos;";
    } else {
      out += c;
    }
  }
  return out;
}

std::string junit_xml(const RunRecord& run) {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  text += fmt::format("<testsuites name=\"orbs\" time=\"{:.3f}\">\n", run.wall_seconds);
  const auto jobs = jobs_by_id(run);
  for (const auto& renderer : run.renderers) text += test_suite(run, jobs, renderer);
  return text + "</testsuites>\n";
}

}  // namespace orbs::report
