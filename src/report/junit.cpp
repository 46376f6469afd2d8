#include "report/junit.h"

#include "base/text.h"
#include "report/table.h"

#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace orbs::report {

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
