#include "history/verdict_changes.h"

namespace orbs::history {

namespace {

using results::TargetRecord;
using results::Verdict;

bool is_failure(const TargetRecord& target) {
  return target.declared && counts_as_failure(target.verdict, target.expectation);
}

bool is_by_noise(const TargetRecord& before, const TargetRecord& after) {
  const auto is_either = [](const TargetRecord& target) {
    return target.verdict == Verdict::Pass || target.verdict == Verdict::Inconclusive;
  };
  return is_either(before) && is_either(after) && before.verdict != after.verdict;
}

Direction direction_of(const TargetRecord& before, const TargetRecord& after) {
  if (is_by_noise(before, after)) return Direction::Neither;
  if (is_failure(before) != is_failure(after))
    return is_failure(after) ? Direction::Worse : Direction::Better;
  if (!is_failure(after) && after.verdict != Verdict::Unsupported && before.verdict != Verdict::Unsupported)
    return after.verdict == Verdict::Pass ? Direction::Better : Direction::Neither;
  return results::is_worse(after.verdict, after.expectation, before.verdict, before.expectation)
             ? Direction::Worse
             : Direction::Better;
}

}  // namespace

std::vector<Change> verdict_changes(const RunPair& pair) {
  std::vector<Change> changes;
  for (const auto& [before, after, ignored] : pair.targets) {
    if (before->verdict == Verdict::Skipped || after->verdict == Verdict::Skipped) continue;
    if (state_name(*before) == state_name(*after)) continue;
    Change change;
    change.quantity = Quantity::Verdict;
    change.direction = direction_of(*before, *after);
    change.renderer = after->renderer;
    change.requirement = after->requirement;
    change.target = after->target;
    change.before = state_name(*before);
    change.after = state_name(*after);
    change.size = static_cast<double>(after->verdict);
    change.reason = reason_text(*after);
    changes.push_back(std::move(change));
  }
  return changes;
}

}  // namespace orbs::history
