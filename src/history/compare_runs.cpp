#include "history/compare_runs.h"

#include "history/number_changes.h"
#include "history/pair_runs.h"
#include "history/time_changes.h"
#include "history/verdict_change.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::history {

namespace {

using results::TargetRecord;
using results::Verdict;

// A requirement that the renderer does not declare is none of its failures.
State state_of(const TargetRecord& target) {
  return {target.declared ? target.verdict : Verdict::Unsupported, target.expectation};
}

Direction direction_of(VerdictChange change) {
  switch (change) {
    case VerdictChange::Worse:
      return Direction::Worse;
    case VerdictChange::Better:
      return Direction::Better;
    case VerdictChange::Same:
    case VerdictChange::Neither:
    case VerdictChange::NotRendered:
      return Direction::Neither;
  }
  return Direction::Neither;
}

// "known (crash)" where the name alone does not tell two states apart.
std::string state_text(const TargetRecord& target, const TargetRecord& other) {
  const auto name = state_name(target);
  if (name != state_name(other)) return std::string(name);
  return fmt::format("{} ({})", name, verdict_name(target.verdict));
}

// Targets whose state differs.
std::vector<Change> verdict_changes(const RunPair& pair) {
  std::vector<Change> changes;
  for (const auto& one : pair.targets) {
    const auto& before = *one.before;
    const auto& after = *one.after;
    const auto what = verdict_change(state_of(before), state_of(after));
    if (what == VerdictChange::Same || what == VerdictChange::NotRendered) continue;
    Change change;
    change.quantity = Quantity::Verdict;
    change.direction = direction_of(what);
    change.renderer = after.renderer;
    change.requirement = after.requirement;
    change.target = after.target;
    change.before = state_text(before, after);
    change.after = state_text(after, before);
    change.size = static_cast<double>(after.verdict);
    change.reason = reason_text(after);
    changes.push_back(std::move(change));
  }
  return changes;
}

std::vector<LostTarget> lost_targets(const RunPair& pair) {
  std::vector<LostTarget> lost;
  for (const auto& name : pair.only_before) lost.push_back({Loss::Vanished, name, ""});
  for (const auto& one : pair.targets) {
    const auto name = one.after->renderer + " " + one.after->target;
    if (!one.not_rendered.empty()) {
      lost.push_back({Loss::NotRendered, name, one.not_rendered});
    } else if (!one.not_compared.empty()) {
      lost.push_back({Loss::NotComparable, name, one.not_compared});
    }
  }
  return lost;
}

void sort_worst_first(std::vector<Change>& changes) {
  std::stable_sort(changes.begin(), changes.end(), [](const Change& a, const Change& b) {
    return std::tuple(a.direction, a.quantity, -a.size) < std::tuple(b.direction, b.quantity, -b.size);
  });
}

// "12 renders: another kind of machine".
void note_times(const std::vector<JobPair>& pairs, std::vector<std::string>& notes) {
  std::map<std::string, int> counts;
  for (const auto& pair : pairs)
    if (!pair.not_compared.empty()) ++counts[pair.not_compared];
  for (const auto& [reason, count] : counts)
    notes.push_back(fmt::format("times of renders of {} not compared: {}", count, reason));
}

// "3 targets".
std::string targets_text(std::size_t count) {
  return fmt::format("{} target{}", count, count == 1 ? "" : "s");
}

// "a, b, c, ...".
std::string first_of(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 8;
  const auto shown = std::min(names.size(), kMost);
  return fmt::format("{}{}",
                     fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown), ", "),
                     shown < names.size() ? ", ..." : "");
}

// "errors of 2 targets not compared, as their numbers of samples differ (a, b)".
void note_other_samples(const std::vector<TargetPair>& pairs, std::vector<std::string>& notes) {
  std::vector<std::string> names;
  for (const auto& pair : pairs)
    if (pair.has_other_samples && pair.not_compared.empty() && has_numbers(*pair.before) &&
        has_numbers(*pair.after))
      names.push_back(pair.after->renderer + " " + pair.after->target);
  if (!names.empty())
    notes.push_back(fmt::format("errors of {} not compared, as their numbers of samples differ ({})",
                                targets_text(names.size()), first_of(names)));
}

void note_only_in(const std::vector<std::string>& names,
                  const std::string& run,
                  std::vector<std::string>& notes) {
  if (!names.empty())
    notes.push_back(fmt::format("{} only in {}: {}", targets_text(names.size()), run, first_of(names)));
}

// "2 targets not rendered: the run was interrupted (a, b)". Those that vanished are noted with their run.
void note_lost(const std::vector<LostTarget>& lost, std::vector<std::string>& notes) {
  std::map<std::pair<Loss, std::string>, std::vector<std::string>> names;
  for (const auto& target : lost)
    if (target.loss != Loss::Vanished) names[{target.loss, target.reason}].push_back(target.target);
  for (const auto& [key, targets] : names)
    notes.push_back(fmt::format("{} {}: {} ({})", targets_text(targets.size()), loss_name(key.first),
                                key.second, first_of(targets)));
}

}  // namespace

std::string loss_name(Loss loss) {
  switch (loss) {
    case Loss::Vanished:
      return "vanished";
    case Loss::NotRendered:
      return "not rendered";
    case Loss::NotComparable:
      return "no longer comparable";
  }
  return {};
}

std::size_t count_of(const RunComparison& comparison, Direction direction) {
  return static_cast<std::size_t>(
      std::count_if(comparison.changes.begin(), comparison.changes.end(),
                    [&](const Change& change) { return change.direction == direction; }));
}

RunComparison compare_pairs(const RunPair& pair,
                            std::vector<Change> verdicts,
                            std::vector<std::vector<Candidate>> numbers) {
  constexpr int kKinds = 3;
  RunComparison comparison{"", "", pair.targets.size(), 0, std::move(verdicts), lost_targets(pair), {}};
  for (auto& candidates : numbers) {
    comparison.tests += candidates.size();
    keep_significant(std::move(candidates), kFalseAlarms / kKinds, comparison.changes);
  }
  sort_worst_first(comparison.changes);
  note_lost(comparison.lost, comparison.notes);
  note_other_samples(pair.targets, comparison.notes);
  note_times(pair.jobs, comparison.notes);
  return comparison;
}

RunComparison compare_runs(const results::RunRecord& before, const results::RunRecord& after) {
  const auto pair = pair_runs(before, after);
  auto comparison = compare_pairs(pair, verdict_changes(pair),
                                  {light_candidates(pair), error_candidates(pair), time_candidates(pair)});
  comparison.before = before.name;
  comparison.after = after.name;
  note_only_in(pair.only_before, comparison.before, comparison.notes);
  note_only_in(pair.only_after, comparison.after, comparison.notes);
  return comparison;
}

results::RunRecord with_renderer(results::RunRecord run, const std::string& renderer, const std::string& as) {
  std::erase_if(run.renderers, [&](const auto& one) { return one.name != renderer; });
  std::erase_if(run.targets, [&](const auto& one) { return one.renderer != renderer; });
  std::erase_if(run.jobs, [&](const auto& one) { return one.identity.renderer != renderer; });
  for (auto& one : run.renderers) one.name = as;
  for (auto& one : run.targets) one.renderer = as;
  for (auto& one : run.jobs) one.identity.renderer = as;
  return run;
}

int exit_status(const RunComparison& comparison) {
  return count_of(comparison, Direction::Worse) > 0 || !comparison.lost.empty() ? 1 : 0;
}

std::vector<RunComparison> compare_variants(const results::RunRecord& run) {
  std::vector<RunComparison> comparisons;
  std::map<std::string, std::string> first;  // variant of each entry
  for (const auto& renderer : run.renderers) {
    if (renderer.variant_of.empty()) continue;
    const auto [base, is_first] = first.try_emplace(renderer.variant_of, renderer.name);
    if (is_first) continue;
    const auto pair = pair_renderers(run, base->second, renderer.name);
    comparisons.push_back(
        compare_pairs(pair, verdict_changes(pair), {light_candidates(pair), error_candidates(pair)}));
    comparisons.back().before = base->second;
    comparisons.back().after = renderer.name;
  }
  return comparisons;
}

}  // namespace orbs::history
