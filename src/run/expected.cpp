#include "run/expected.h"

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "registry/cases.h"
#include "registry/filters.h"
#include "results/record.h"
#include "run/summary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::run {

namespace {

using registry::ExpectedFailure;
using results::Check;
using results::Expectation;
using results::Measure;
using results::TargetRecord;
using results::Verdict;

// A run that ended early and a reference that is missing say nothing of the renderer.
bool can_be_expected(Verdict verdict) {
  return results::counts_as_failure(verdict) && verdict != Verdict::Skipped &&
         verdict != Verdict::MissingReference;
}

void refuse_unknown_verdict(const ExpectedFailure& entry) {
  std::set<std::string> names;
  for (const auto verdict : results::kVerdicts)
    if (can_be_expected(verdict)) names.emplace(results::verdict_name(verdict));
  if (!names.contains(entry.verdict))
    throw InputError(fmt::format("{}: no failure has the verdict '{}'{}; there are {}", entry.place,
                                 entry.verdict, closest(entry.verdict, names), fmt::join(names, ", ")));
}

void add_targets(const std::vector<registry::Case>& cases, std::set<std::string>& names) {
  for (const auto& one_case : cases)
    for (auto& name : registry::target_names(one_case)) names.insert(std::move(name));
}

std::vector<std::string> unknown_scenes(const ExpectedFailure& entry, const std::set<std::string>& targets) {
  std::vector<std::string> unknown;
  for (const auto& pattern : registry::patterns_of(entry.scene))
    if (std::none_of(targets.begin(), targets.end(),
                     [&](const auto& name) { return glob_match(pattern, name); }))
      unknown.push_back(pattern);
  return unknown;
}

const Measure* measure_of(const TargetRecord& target, const std::string& check) {
  const auto found = std::find_if(target.measures.begin(), target.measures.end(),
                                  [&](const Measure& measure) { return measure.name == check; });
  return found == target.measures.end() ? nullptr : &*found;
}

// How far a number is from a perfect one, see kMuchWorse.
double error_of(double value, const std::string& unit, const Check& check) {
  if (unit == "dB") return std::pow(10, -value / 10);
  if (check.min && check.max) return std::fabs(value - (*check.min + *check.max) / 2);
  return check.max ? std::fabs(value) : std::fabs(1 - value);
}

// The least error that the interval of the number allows.
double least_error(const Measure& measure, const Check& check) {
  const double low = measure.low.value_or(measure.value);
  const double high = measure.high.value_or(measure.value);
  const double of_low = error_of(low, measure.unit, check);
  const double of_high = error_of(high, measure.unit, check);
  const double middle = check.min && check.max ? (*check.min + *check.max) / 2 : check.max ? 0 : 1;
  if (measure.unit != "dB" && low < middle && middle < high) return 0;
  return std::min(of_low, of_high);
}

bool is_failed(const Check& check) { return check.measured && check.decided && !check.passed; }

// What noise left undecided once may be decided in a run of another seed: it belongs to the failure, too.
bool is_not_met(const Check& check) { return check.measured && !check.passed; }

// What is news about a target that has the expected verdict; "" if nothing is.
std::string news_of_checks(const TargetRecord& target, const ExpectedFailure& entry) {
  const bool fails_a_check = std::any_of(target.checks.begin(), target.checks.end(), is_failed);
  if (target.verdict == Verdict::Fail && !fails_a_check)
    return fmt::format("it fails although it meets every check, and no failure of {} was of that kind",
                       entry.place);
  if (entry.measure.empty()) return "";
  for (const auto& check : target.checks) {
    if (!is_failed(check)) continue;
    const auto recorded = entry.measure.find(check.what);
    if (recorded == entry.measure.end())
      return fmt::format("it fails by {}, which is not among the failed checks of {}", check.what,
                         entry.place);
    const auto* measure = measure_of(target, check.what);
    if (measure == nullptr || !recorded->second) continue;
    // Also where there is no number to be compared.
    if (!(least_error(*measure, check) <= kMuchWorse * error_of(*recorded->second, measure->unit, check)))
      return fmt::format("{} is {:.5g}, much worse than the {:.5g} that {} has", check.what, measure->value,
                         *recorded->second, entry.place);
  }
  return "";
}

void set_news(TargetRecord& target, const std::string& text) {
  target.expectation = Expectation::News;
  target.expected = text;
}

}  // namespace

void refuse_unknown_expected(const registry::Configuration& configuration,
                             const registry::Suite& suite,
                             const std::vector<registry::Case>& cases) {
  std::set<std::string> targets;
  add_targets(cases, targets);
  bool has_all = false;
  for (const auto& entry : configuration.expected) {
    refuse_unknown_verdict(entry);
    // Cases of other suites are read only if they are needed.
    if (!has_all && !unknown_scenes(entry, targets).empty()) {
      for (const auto& other : configuration.suites)
        if (other.name != suite.name) add_targets(registry::load_cases(other), targets);
      has_all = true;
    }
    if (const auto unknown = unknown_scenes(entry, targets); !unknown.empty())
      throw InputError(fmt::format("{}: no scene of any suite matches '{}'{}", entry.place, unknown.front(),
                                   closest(unknown.front(), targets)));
  }
}

namespace {

void mark_target(const ExpectedFailure* entry, TargetRecord& target) {
  target.expectation = Expectation::None;
  target.expected.clear();
  if (entry == nullptr || !target.declared) return;
  if (target.verdict == Verdict::Pass) {
    set_news(target, fmt::format("it passes, but {} expects '{}' ({}): remove the entry", entry->place,
                                 entry->verdict, entry->reason));
  } else if (!can_be_expected(target.verdict)) {
    return;
  } else if (results::verdict_name(target.verdict) != entry->verdict) {
    set_news(target, fmt::format("{} expects '{}'", entry->place, entry->verdict));
  } else if (const auto news = news_of_checks(target, *entry); !news.empty()) {
    set_news(target, news);
  } else {
    target.expectation = Expectation::Known;
    target.expected = entry->reason;
  }
}

}  // namespace

void mark_expected(const std::vector<ExpectedFailure>& expected,
                   const Versions& versions,
                   std::vector<TargetRecord>& targets) {
  std::set<std::pair<std::string, std::string>> failing;
  for (const auto& target : targets)
    if (can_be_expected(target.verdict)) failing.emplace(target.renderer, target.target);
  for (auto& target : targets) {
    const auto version = versions.find(target.renderer);
    const auto* entry = registry::find_expected(
        expected, target.renderer, version == versions.end() ? "" : version->second, target.target);
    const bool fails_elsewhere =
        target.verdict == Verdict::Pass && failing.contains({target.renderer, target.target});
    mark_target(fails_elsewhere ? nullptr : entry, target);
  }
}

void mark_expected(const std::vector<ExpectedFailure>& expected, results::RunRecord& run) {
  Versions versions;
  for (const auto& renderer : run.renderers) versions[renderer.name] = renderer.version;
  mark_expected(expected, versions, run.targets);
}

std::vector<ExpectedFailure> accepted_failures(const results::RunRecord& run, const std::string& reason) {
  std::vector<ExpectedFailure> accepted;
  for (const auto& target : run.targets) {
    if (!target.declared || !can_be_expected(target.verdict) || target.expectation == Expectation::Known)
      continue;
    ExpectedFailure entry;
    entry.renderer = target.renderer;
    entry.scene = target.target;
    entry.verdict = results::verdict_name(target.verdict);
    entry.reason = reason;
    for (const auto& check : target.checks) {
      if (!is_not_met(check)) continue;
      const auto* measure = measure_of(target, check.what);
      const bool has_number = measure != nullptr && std::isfinite(measure->value);
      entry.measure[check.what] = has_number ? std::optional<double>(measure->value) : std::nullopt;
    }
    // A target that several cases judge has one entry, with the failed checks of all.
    const auto same = std::find_if(accepted.begin(), accepted.end(), [&](const ExpectedFailure& other) {
      return other.renderer == entry.renderer && other.scene == entry.scene && other.verdict == entry.verdict;
    });
    if (same == accepted.end()) {
      accepted.push_back(std::move(entry));
    } else {
      same->measure.insert(entry.measure.begin(), entry.measure.end());
    }
  }
  return accepted;
}

std::size_t accept_failures(const std::filesystem::path& configuration,
                            const std::string& reason,
                            results::RunRecord& run) {
  const auto accepted = accepted_failures(run, reason);
  if (accepted.empty()) return 0;
  // Through a symbolic link, which is to stay one.
  const auto file = std::filesystem::canonical(configuration);
  // It may have been edited while the run went on.
  const auto text = read_file(file);
  const auto read =
      with_note(fmt::format("accepting failures; {} is as it was", configuration.string()), [&] {
        const auto present = registry::parse_configuration(configuration, text);
        const auto changed = registry::with_expected(text, present.expected, accepted);
        auto parsed = registry::parse_configuration(configuration, changed);
        write_file(file, changed);
        return parsed;
      });
  mark_expected(read.expected, run);
  summarise(run);
  write_file(std::filesystem::path(run.folder) / "results.json", results::run_json(run));
  return accepted.size();
}

}  // namespace orbs::run
