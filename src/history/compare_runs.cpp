#include "history/compare_runs.h"

#include "base/text_table.h"
#include "history/number_changes.h"
#include "history/pair_runs.h"
#include "history/time_changes.h"
#include "json/writer.h"

#include <algorithm>
#include <map>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

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

// Targets whose state differs. It is worse if it counts as a failure now and did not before, if it is a
// worse failure, or if a pass became unsupported; a change between pass and inconclusive is neither, since
// noise decides there. What was skipped in one of the runs is not compared.
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

void sort_worst_first(std::vector<Change>& changes) {
  std::stable_sort(changes.begin(), changes.end(), [](const Change& a, const Change& b) {
    return std::tuple(a.direction, a.quantity, -a.size) < std::tuple(b.direction, b.quantity, -b.size);
  });
}

// "12 renders: another kind of machine".
template <typename Pairs>
void note_reasons(const Pairs& pairs, const std::string& what, std::vector<std::string>& notes) {
  std::map<std::string, int> counts;
  for (const auto& pair : pairs)
    if (!pair.not_compared.empty()) ++counts[pair.not_compared];
  for (const auto& [reason, count] : counts)
    notes.push_back(fmt::format("{} of {} not compared: {}", what, count, reason));
}

void note_lonely(const std::vector<std::string>& names,
                 const std::string& run,
                 std::vector<std::string>& notes) {
  constexpr std::size_t kMost = 8;
  if (names.empty()) return;
  const auto shown = std::min(names.size(), kMost);
  notes.push_back(
      fmt::format("{} targets are only in {}: {}{}", names.size(), run,
                  fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown), ", "),
                  shown < names.size() ? ", ..." : ""));
}

std::string target_text(const Change& change) {
  return change.target.empty() ? "all together" : change.target;
}

std::vector<TableRow> rows_of(const RunComparison& comparison) {
  std::vector<TableRow> rows{{"", "renderer", "", "target", "", "before", "after", "by chance", ""}};
  for (const auto& change : comparison.changes)
    rows.push_back({direction_name(change.direction), change.renderer, change.requirement,
                    target_text(change), quantity_name(change.quantity), change.before, change.after,
                    chance_text(change), change.reason});
  return rows;
}

std::size_t count_of(const RunComparison& comparison, Direction direction) {
  return static_cast<std::size_t>(
      std::count_if(comparison.changes.begin(), comparison.changes.end(),
                    [&](const Change& change) { return change.direction == direction; }));
}

std::string headline(const RunComparison& comparison) {
  return fmt::format("{} worse, {} better, {} changed otherwise", count_of(comparison, Direction::Worse),
                     count_of(comparison, Direction::Better), count_of(comparison, Direction::Neither));
}

std::string what_was_compared(const RunComparison& comparison) {
  return fmt::format(
      "{} targets, {} tests of numbers. Of equal programs on an equal machine, 1 comparison in {:.0f} calls any "
      "number changed.",
      comparison.targets, comparison.tests, 1 / kFalseAlarms);
}

}  // namespace

RunComparison compare_pairs(const RunPair& pair,
                            std::vector<Change> verdicts,
                            std::vector<std::vector<Candidate>> numbers) {
  constexpr int kKinds = 3;
  RunComparison comparison{"", "", pair.targets.size(), 0, std::move(verdicts), {}};
  for (auto& candidates : numbers) {
    comparison.tests += candidates.size();
    keep_significant(std::move(candidates), kFalseAlarms / kKinds, comparison.changes);
  }
  sort_worst_first(comparison.changes);
  note_reasons(pair.targets, "numbers of targets", comparison.notes);
  note_reasons(pair.jobs, "times of renders", comparison.notes);
  return comparison;
}

RunComparison compare_runs(const results::RunRecord& before, const results::RunRecord& after) {
  const auto pair = pair_runs(before, after);
  auto comparison = compare_pairs(pair, verdict_changes(pair),
                                  {light_candidates(pair), error_candidates(pair), time_candidates(pair)});
  comparison.before = before.name;
  comparison.after = after.name;
  note_lonely(pair.only_before, comparison.before, comparison.notes);
  note_lonely(pair.only_after, comparison.after, comparison.notes);
  return comparison;
}

int exit_status(const RunComparison& comparison) {
  return count_of(comparison, Direction::Worse) > 0 ? 1 : 0;
}

std::string comparison_text(const RunComparison& comparison, int width) {
  std::string text;
  const auto add = [&](const std::string& line) {
    text += fmt::format("{}\n", fmt::join(wrapped(line, static_cast<std::size_t>(width)), "\n"));
  };
  add(fmt::format("{} against {}: {}", comparison.after, comparison.before, headline(comparison)));
  if (!comparison.changes.empty())
    text += fmt::format("\n{}\n", text_table(rows_of(comparison), {}, {width, {}}));
  add(what_was_compared(comparison));
  for (const auto& note : comparison.notes) add(note);
  return text;
}

std::string comparison_markdown(const RunComparison& comparison) {
  auto text = fmt::format("**{}** (`{}` against `{}`)\n\n", headline(comparison), comparison.after,
                          comparison.before);
  if (!comparison.changes.empty()) text += markdown_table(rows_of(comparison)) + "\n";
  text += what_was_compared(comparison) + "\n";
  for (const auto& note : comparison.notes) text += fmt::format("- {}\n", note);
  return text;
}

std::string comparison_json(const RunComparison& comparison) {
  json::Writer out;
  out.begin_object().member("format", "orbs-comparison/1");
  out.member("before", comparison.before).member("after", comparison.after);
  out.member("targets", static_cast<unsigned long long>(comparison.targets));
  out.member("tests", static_cast<unsigned long long>(comparison.tests));
  out.member("false_alarm_rate", kFalseAlarms).key("changes").begin_array();
  for (const auto& change : comparison.changes)
    out.begin_object()
        .member("direction", direction_name(change.direction))
        .member("quantity", quantity_name(change.quantity))
        .member("renderer", change.renderer)
        .member("requirement", change.requirement)
        .member("target", change.target)
        .member("before", change.before)
        .member("after", change.after)
        .member("probability", change.by_chance)
        .member("reason", change.reason)
        .end_object();
  out.end_array().member("notes", comparison.notes);
  return out.end_object().text();
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

std::string variants_text(const std::vector<RunComparison>& comparisons) {
  constexpr std::size_t kMost = 8;
  std::string text;
  for (const auto& comparison : comparisons) {
    const auto& changes = comparison.changes;
    text += fmt::format("{} against {}: {} targets, {}\n", comparison.after, comparison.before,
                        comparison.targets,
                        changes.empty() ? "the same but for noise"
                                        : fmt::format("{} differences beyond noise", changes.size()));
    for (std::size_t i = 0; i < std::min(changes.size(), kMost); ++i)
      text += fmt::format("  {} {}: {}, {} against {}\n", changes[i].requirement,
                          changes[i].target.empty() ? "all together" : changes[i].target,
                          quantity_name(changes[i].quantity), changes[i].after, changes[i].before);
    if (changes.size() > kMost) text += fmt::format("  and {} more\n", changes.size() - kMost);
  }
  return text;
}

}  // namespace orbs::history
