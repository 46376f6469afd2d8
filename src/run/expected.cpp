#include "run/expected.h"

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "registry/cases.h"
#include "registry/filters.h"
#include "registry/version_range.h"
#include "results/least_change.h"
#include "results/record.h"
#include "run/accepted_number.h"
#include "run/summary.h"

#include <algorithm>
#include <cmath>
#include <map>
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

using results::can_be_expected;

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

bool is_failed(const Check& check) { return check.measured && check.decided && !check.passed; }

// What noise left undecided once may be decided in a run of another seed: it belongs to the failure, too.
bool is_not_met(const Check& check) { return check.measured && !check.passed; }

double tolerance_of(const ExpectedFailure& entry) { return entry.tolerance.value_or(results::kLeastError); }

// What is news about a check that is not met and has the number `accepted` in the entry; "" if nothing is.
std::string news_of_number(double accepted,
                           const Check& check,
                           const TargetRecord& target,
                           const ExpectedFailure& entry) {
  const auto* measure = measure_of(target, check.what);
  if (measure == nullptr) return "";
  const auto is = number_said(measure->value, check);
  const auto had = number_text(accepted, check);
  switch (compare_with_accepted(accepted, check, target, tolerance_of(entry))) {
    case AcceptedChange::Within:
    case AcceptedChange::Better:
      return "";
    case AcceptedChange::Worse:
      return fmt::format("{}, which is worse than {}, the failure that {} accepts", is, had, entry.place);
    case AcceptedChange::OtherSide:
      return fmt::format("{}, wrong to the other side than {}, the failure that {} accepts", is, had,
                         entry.place);
  }
  return "";
}

// What is news about a target that has the expected verdict; "" if nothing is.
std::string news_of_checks(const TargetRecord& target, const ExpectedFailure& entry) {
  const bool fails_a_check = std::any_of(target.checks.begin(), target.checks.end(), is_failed);
  if (target.verdict == Verdict::Fail && !fails_a_check)
    return fmt::format("it fails although it meets every check, and no failure of {} was of that kind",
                       entry.place);
  if (entry.measure.empty()) return "";
  for (const auto& check : target.checks) {
    if (!is_not_met(check)) continue;
    const auto recorded = entry.measure.find(check.what);
    if (recorded == entry.measure.end()) {
      if (!is_failed(check)) continue;
      return fmt::format("it fails by {}, which is not among the failed checks of {}", check.what,
                         entry.place);
    }
    if (!recorded->second) continue;
    // A PSNR that is left open holds the noise of as many samples as there were.
    if (!is_failed(check) && check.what == "psnr_srgb8") continue;
    if (auto news = news_of_number(*recorded->second, check, target, entry); !news.empty()) return news;
  }
  return "";
}

// "psnr_srgb8 is 34.2, was 30; pixels [0,0,1,1] is met": what is better than accepted by more than noise.
std::string better_checks(const TargetRecord& target, const ExpectedFailure& entry) {
  std::vector<std::string> better;
  for (const auto& check : target.checks) {
    const auto recorded = entry.measure.find(check.what);
    if (!check.measured || recorded == entry.measure.end()) continue;
    const auto* measure = measure_of(target, check.what);
    if (recorded->second && measure != nullptr) {
      if (compare_with_accepted(*recorded->second, check, target, tolerance_of(entry)) ==
          AcceptedChange::Better)
        better.push_back(fmt::format("{}, was {}", number_said(measure->value, check),
                                     number_text(*recorded->second, check)));
    } else if (check.passed) {
      better.push_back(fmt::format("{} is met", check.what));
    }
  }
  return fmt::format("{}", fmt::join(better, "; "));
}

void set_news(TargetRecord& target, const std::string& text) {
  target.expectation = Expectation::News;
  target.expected = text;
}

}  // namespace

void refuse_unknown_expected(const registry::Configuration& configuration,
                             const registry::Suite& suite,
                             const std::vector<registry::Case>& cases) {
  // Cases of other suites are read only if they are needed.
  std::map<std::string, std::set<std::string>> targets;
  add_targets(cases, targets[suite.name]);
  for (const auto& entry : configuration.expected) {
    refuse_unknown_verdict(entry);
    std::set<std::string> known;
    if (entry.suite.value_or(suite.name) == suite.name) known = targets[suite.name];
    for (const auto& other : configuration.suites) {
      if (entry.suite.value_or(other.name) != other.name || unknown_scenes(entry, known).empty()) continue;
      if (const auto [names, is_new] = targets.try_emplace(other.name); is_new)
        add_targets(registry::load_cases(other), names->second);
      known.insert(targets[other.name].begin(), targets[other.name].end());
    }
    if (const auto unknown = unknown_scenes(entry, known); !unknown.empty())
      throw InputError(fmt::format("{}: no scene of {} matches '{}'{}", entry.place,
                                   entry.suite ? fmt::format("the suite '{}'", *entry.suite) : "any suite",
                                   unknown.front(), closest(unknown.front(), known)));
  }
}

namespace {

// "psnr_srgb8 is 34.2, was 30: better than accepted; accept it anew".
std::string known_text(const TargetRecord& target, const ExpectedFailure& entry) {
  const auto better = better_checks(target, entry);
  if (better.empty()) return entry.reason;
  return fmt::format("{}; better than {} accepts ({}): accept it anew", entry.reason, entry.place, better);
}

// Where the renderer tells its version, another one may still fail, and the entry is to stay for that.
std::string what_becomes_of(const ExpectedFailure& entry, const std::string& version) {
  if (registry::is_absent(registry::range_of_version(version))) return "remove the entry";
  return fmt::format(
      "{} of those that fail if {} is not one of them, else remove the entry",
      registry::is_absent(entry.version) ? "add \"version\"" : "narrow its \"version\" to that", version);
}

void mark_target(const registry::FoundExpected& found,
                 const std::string& version,
                 bool is_strict,
                 TargetRecord& target) {
  target.expectation = Expectation::None;
  target.expected.clear();
  if (!target.declared) return;
  if (const auto* expired = found.expired; expired != nullptr && can_be_expected(target.verdict))
    set_news(target, fmt::format("{} accepted it until {} and has expired ({})", expired->place,
                                 expired->until->text, expired->reason));
  const auto* entry = found.counting;
  if (entry == nullptr) {
    if (is_strict && target.verdict == Verdict::PassWithRemarks)
      set_news(target, "a strict run accepts no remarks");
    return;
  }
  // Fewer samples leave open what more of them have shown to be wrong.
  const bool is_left_open =
      target.verdict == Verdict::Inconclusive && entry->verdict == results::verdict_name(Verdict::Fail);
  const bool is_known = results::verdict_name(target.verdict) == entry->verdict || is_left_open;
  if (passes(target.verdict) && !is_known) {
    set_news(target, fmt::format("it passes, but {} expects '{}' ({}): {}", entry->place, entry->verdict,
                                 entry->reason, what_becomes_of(*entry, version)));
  } else if (!can_be_expected(target.verdict)) {
    return;
  } else if (!is_known) {
    set_news(target, fmt::format("{} expects '{}'", entry->place, entry->verdict));
  } else if (const auto news = news_of_checks(target, *entry); !news.empty()) {
    set_news(target, news);
  } else {
    target.expectation = Expectation::Known;
    target.expected = known_text(target, *entry);
  }
}

registry::RunKind kind_of(const results::RunRecord& run) {
  return {run.suite, registry::size_divisor(run.size), registry::day_of(run.started), run.strict};
}

std::string version_of(const Versions& versions, const std::string& renderer) {
  const auto version = versions.find(renderer);
  return version == versions.end() ? "" : version->second;
}

Versions versions_of(const results::RunRecord& run) {
  Versions versions;
  for (const auto& renderer : run.renderers) versions[renderer.name] = renderer.version;
  return versions;
}

}  // namespace

void mark_expected(const std::vector<ExpectedFailure>& expected,
                   const registry::RunKind& run,
                   const Versions& versions,
                   std::vector<TargetRecord>& targets) {
  std::map<std::pair<std::string, std::string>, Verdict> worst;
  for (const auto& target : targets)
    if (can_be_expected(target.verdict)) {
      auto& verdict = worst[{target.renderer, target.target}];
      verdict = results::worse(verdict, target.verdict);
    }
  for (auto& target : targets) {
    const bool fails_elsewhere =
        passes(target.verdict) && worst[{target.renderer, target.target}] > target.verdict;
    const auto version = version_of(versions, target.renderer);
    mark_target(fails_elsewhere
                    ? registry::FoundExpected{}
                    : registry::find_expected(expected, target.renderer, version, target.target, run),
                version, run.strict, target);
  }
}

void mark_expected(const std::vector<ExpectedFailure>& expected, results::RunRecord& run) {
  mark_expected(expected, kind_of(run), versions_of(run), run.targets);
}

namespace {

ExpectedFailure accepted_failure(const TargetRecord& target, const results::RunRecord& run) {
  ExpectedFailure entry;
  entry.renderer = target.renderer;
  entry.scene = target.target;
  entry.suite = run.suite;
  entry.size = registry::size_divisor(run.size);
  entry.verdict = results::verdict_name(target.verdict);
  for (const auto& check : target.checks) {
    if (!is_not_met(check)) continue;
    const auto* measure = measure_of(target, check.what);
    const bool has_number = measure != nullptr && std::isfinite(measure->value);
    entry.measure[check.what] = has_number ? std::optional<double>(measure->value) : std::nullopt;
  }
  return entry;
}

// The reason of the entry that a known failure is better than; nothing for one that is as it was accepted.
std::optional<std::string> reason_if_better(const TargetRecord& target,
                                            const std::vector<ExpectedFailure>& present,
                                            const results::RunRecord& run) {
  const auto* entry =
      registry::find_expected(present, target.renderer, version_of(versions_of(run), target.renderer),
                              target.target, kind_of(run))
          .counting;
  if (entry == nullptr || better_checks(target, *entry).empty()) return std::nullopt;
  return entry->reason;
}

}  // namespace

std::vector<ExpectedFailure> accepted_failures(const results::RunRecord& run,
                                               const std::vector<ExpectedFailure>& present,
                                               const std::string& reason) {
  std::vector<ExpectedFailure> accepted;
  for (const auto& target : run.targets) {
    if (!target.declared || !can_be_expected(target.verdict)) continue;
    if (target.verdict == Verdict::PassWithRemarks && !run.strict) continue;
    auto entry = accepted_failure(target, run);
    entry.version = registry::range_of_version(version_of(versions_of(run), target.renderer));
    entry.reason = reason;
    if (target.expectation == Expectation::Known) {
      const auto kept = reason_if_better(target, present, run);
      if (!kept) continue;
      entry.reason = *kept;
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

Acceptance acceptance_of(const registry::Configuration& configuration,
                         const AcceptSettings& settings,
                         const results::RunRecord& run) {
  const auto& own = configuration.own_file;
  const auto files = registry::with_own(configuration.files, own);
  Acceptance change;
  // It may have been edited since the configuration was read.
  change.before = registry::own_text(own);
  const auto present = registry::load_configuration(files, registry::EditedFile{own, change.before});
  auto accepted = accepted_failures(run, present.expected, settings.reason);
  for (auto& entry : accepted) entry.until = settings.until;
  change.entries = accepted.size();
  change.after = registry::with_expected(change.before, registry::expected_of_text(own, change.before),
                                         accepted, registry::day_of(run.started));
  change.expected = registry::load_configuration(files, registry::EditedFile{own, change.after}).expected;
  return change;
}

std::size_t accept_failures(const registry::Configuration& configuration,
                            const std::string& reason,
                            results::RunRecord& run) {
  const auto& own = configuration.own_file;
  const auto accepted = with_note(fmt::format("accepting failures; {} is as it was", own.string()), [&] {
    auto change = acceptance_of(configuration, {reason, {}}, run);
    if (change.entries > 0) registry::write_own(own, change.after);
    return change;
  });
  if (accepted.entries == 0) return 0;
  mark_expected(accepted.expected, run);
  summarise(run);
  write_file(std::filesystem::path(run.folder) / "results.json", results::run_json(run));
  return accepted.entries;
}

}  // namespace orbs::run
