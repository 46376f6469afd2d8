#include "report/junit.h"

#include "base/text.h"

#include <fmt/format.h>

namespace orbs::report {

namespace {

using results::RunRecord;
using results::TargetRecord;

enum class Element { None, Failure, Error, Skipped };

Element element_of(const TargetRecord& target) {
  if (!target.declared || target.expectation == results::Expectation::Known) return Element::Skipped;
  using results::VerdictKind;
  switch (results::kind_of(target.verdict)) {
    case VerdictKind::Pass:  // a failure where it is unexpected, or has remarks in a strict run
      return counts_as_failure(target.verdict, target.expectation) ? Element::Failure : Element::None;
    case VerdictKind::Unsupported:
    case VerdictKind::Skipped:
      return Element::Skipped;
    case VerdictKind::Inconclusive:
    case VerdictKind::MissingReference:
    case VerdictKind::WrongImage:
      return Element::Failure;
    case VerdictKind::NoImage:
      return Element::Error;
  }
  return Element::Error;
}

std::string tag_of(Element element) {
  switch (element) {
    case Element::None:
      return "";
    case Element::Failure:
      return "failure";
    case Element::Error:
      return "error";
    case Element::Skipped:
      return "skipped";
  }
  return "";
}

// The reason, which a diagnosis leads, and the remarks, and the command that renders it again: GitLab and
// dorny/test-reporter show this text alone, Jenkins below the message.
std::string details(const results::JobsById& jobs, const TargetRecord& target) {
  auto text = reason_text(target);
  const auto add = [&](const std::string& line) {
    if (!line.empty()) text += (text.empty() ? "" : "\n") + line;
  };
  if (!names_a_fault(target)) add(target.diagnosis);
  for (const auto& remark : target.remarks) add(remark);
  add(results::command_of(jobs, target));
  return text;
}

std::string outcome_element(const results::JobsById& jobs, const TargetRecord& target) {
  const auto text = xml_text(details(jobs, target));
  const auto tag = tag_of(element_of(target));
  if (tag.empty()) return text.empty() ? "" : fmt::format("      <system-out>{}</system-out>\n", text);
  const auto state = state_name(target);
  return fmt::format("      <{} type=\"{}\" message=\"{}\">{}</{}>\n", tag, xml_text(state),
                     xml_text(clean_line(fmt::format("{}: {}", state, reason_text(target)))), text, tag);
}

// Of a difference none, since its renders are targets of their own.
double seconds_of(const results::JobsById& jobs, const TargetRecord& target) {
  if (target.jobs.size() != 1) return 0;
  const auto job = jobs.find(target.jobs.front());
  return job == jobs.end() ? 0 : job->second->cost.wall_seconds;
}

std::string suite_name(const RunRecord& run, const std::string& renderer, const std::string& requirement) {
  return fmt::format("{}.{}.{}", run.suite, renderer, requirement);
}

// Case and target, as several cases of a requirement may judge one scene.
std::string test_case(const std::string& suite, const results::JobsById& jobs, const TargetRecord& target) {
  return fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\">\n{}    </testcase>\n",
                     xml_text(suite), xml_text(target.case_name + " " + target.target),
                     seconds_of(jobs, target), outcome_element(jobs, target));
}

std::string property(std::string_view name, std::string_view value) {
  return fmt::format("      <property name=\"{}\" value=\"{}\"/>\n", name, xml_text(value));
}

struct Counts {
  int tests = 0;
  int failures = 0;
  int errors = 0;
  int skipped = 0;
};

void count(Element element, Counts& counts) {
  ++counts.tests;
  counts.failures += element == Element::Failure ? 1 : 0;
  counts.errors += element == Element::Error ? 1 : 0;
  counts.skipped += element == Element::Skipped ? 1 : 0;
}

// "" where the renderer has no target of the requirement.
std::string test_suite(const RunRecord& run,
                       const results::JobsById& jobs,
                       const results::RendererRecord& renderer,
                       const results::RequirementRecord& requirement,
                       Counts& all) {
  const auto name = suite_name(run, renderer.name, requirement.code);
  Counts counts;
  double seconds = 0;
  std::string cases;
  for (const auto& target : run.targets) {
    if (target.renderer != renderer.name || target.requirement != requirement.code) continue;
    count(element_of(target), counts);
    count(element_of(target), all);
    seconds += seconds_of(jobs, target);
    cases += test_case(name, jobs, target);
  }
  if (counts.tests == 0) return "";
  return fmt::format(
             "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" "
             "time=\"{:.3f}\" timestamp=\"{}\">\n    <properties>\n",
             xml_text(name), counts.tests, counts.failures, counts.errors, counts.skipped, seconds,
             xml_text(run.started)) +
         property("title", requirement.title) + property("size", run.size) +
         property("version", renderer.version) + fmt::format("    </properties>\n{}  </testsuite>\n", cases);
}

}  // namespace

namespace {

// U+FFFE and U+FFFF, the only characters that clean_text() leaves and XML does not have ("Extensible Markup
// Language (XML) 1.0", 2.2, Char).
bool is_no_character(std::string_view text) {
  return text.starts_with("\xef\xbf\xbe") || text.starts_with("\xef\xbf\xbf");
}

}  // namespace

std::string xml_text(std::string_view text) {
  constexpr std::string_view kReplacement = "\xef\xbf\xbd";
  std::string out;
  auto clean = clean_text(text);
  for (std::size_t i = 0; i < clean.size(); ++i)
    if (is_no_character(std::string_view(clean).substr(i)))
      clean.replace(i, kReplacement.size(), kReplacement);
  for (const char c : clean) {
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
  const auto jobs = jobs_by_id(run);
  Counts all;
  std::string suites;
  for (const auto& renderer : run.renderers)
    for (const auto& requirement : run.requirements)
      suites += test_suite(run, jobs, renderer, requirement, all);
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuites name=\"orbs\" tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\">\n{}</testsuites>\n",
      all.tests, all.failures, all.errors, run.wall_seconds, suites);
}

}  // namespace orbs::report
