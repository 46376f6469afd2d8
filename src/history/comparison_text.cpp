#include "history/comparison_text.h"

#include "base/text_table.h"
#include "history/change_colours.h"
#include "json/writer.h"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::history {

namespace {

std::string target_text(const Change& change) {
  return change.target.empty() ? "all together" : change.target;
}

std::vector<TableRow> rows_of(const std::vector<Change>& changes) {
  std::vector<TableRow> rows{{"", "renderer", "", "target", "", "before", "after", "by chance", ""}};
  for (const auto& change : changes)
    rows.push_back({direction_name(change.direction), change.renderer, change.requirement,
                    target_text(change), quantity_name(change.quantity), change.before, change.after,
                    chance_text(change), change.reason});
  return rows;
}

// Of a target what is worst, which comes first; what else changed the same way is named behind it: eleven
// rows of two targets say no more.
std::vector<Change> one_of_each_target(const std::vector<Change>& changes) {
  std::vector<Change> first;
  for (const auto& change : changes) {
    const auto same = std::find_if(first.begin(), first.end(), [&](const Change& other) {
      return other.direction == change.direction && other.renderer == change.renderer &&
             other.target == change.target && !change.target.empty();
    });
    if (same == first.end()) {
      first.push_back(change);
    } else if (same->quantity != change.quantity) {  // several requirements may judge one target
      const auto also =
          fmt::format("{} {} to {}", quantity_name(change.quantity), change.before, change.after);
      same->reason += same->reason.empty() ? "also " + also : "; also " + also;
    }
  }
  return first;
}

std::string headline(const RunComparison& comparison) {
  auto text = fmt::format("{} worse, {} better, {} changed otherwise", count_of(comparison, Direction::Worse),
                          count_of(comparison, Direction::Better), count_of(comparison, Direction::Neither));
  for (const auto loss : {Loss::Vanished, Loss::NotRendered, Loss::NotComparable}) {
    const auto count = std::count_if(comparison.lost.begin(), comparison.lost.end(),
                                     [&](const LostTarget& target) { return target.loss == loss; });
    if (count > 0) text += fmt::format(", {} {}", count, loss_name(loss));
  }
  return text;
}

// Of the worst that was found.
std::string_view headline_colour(const RunComparison& comparison) {
  if (exit_status(comparison) != 0) return colour::kRed;
  return count_of(comparison, Direction::Better) > 0 ? colour::kGreen : "";
}

std::string what_was_compared(const RunComparison& comparison) {
  return fmt::format(
      "{} targets, {} tests of numbers. Of equal programs on an equal machine, 1 comparison in {:.0f} calls any "
      "number changed.",
      comparison.targets, comparison.tests, 1 / kFalseAlarms);
}

}  // namespace

std::string comparison_text(const RunComparison& comparison, const TerminalStyle& style) {
  std::string text;
  const auto add = [&](const std::string& line) { text += wrapped_lines(line + '\n', style.width); };
  add(fmt::format("{} against {}: {}", comparison.after, comparison.before,
                  painted(headline(comparison), headline_colour(comparison), style)));
  const auto changes = one_of_each_target(comparison.changes);
  if (!changes.empty())
    text += fmt::format("\n{}\n",
                        text_table(rows_of(changes), {}, {style.width, direction_colours(changes, style)}));
  add(what_was_compared(comparison));
  for (const auto& note : comparison.notes) add(note);
  return text;
}

std::string comparison_markdown(const RunComparison& comparison) {
  auto text = fmt::format("**{}** (`{}` against `{}`)\n\n", headline(comparison), comparison.after,
                          comparison.before);
  if (!comparison.changes.empty())
    text += markdown_table(rows_of(one_of_each_target(comparison.changes))) + "\n";
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
  out.end_array().key("lost").begin_array();
  for (const auto& target : comparison.lost)
    out.begin_object()
        .member("loss", loss_name(target.loss))
        .member("target", target.target)
        .member("reason", target.reason)
        .end_object();
  out.end_array().member("notes", comparison.notes);
  return out.end_object().text();
}

std::string variants_text(const std::vector<RunComparison>& comparisons) {
  constexpr std::size_t kMost = 8;
  std::string text;
  for (const auto& comparison : comparisons) {
    const auto& changes = comparison.changes;
    const auto lost = comparison.lost.size();
    text += fmt::format("{} against {}: {} targets, {}{}\n", comparison.after, comparison.before,
                        comparison.targets,
                        changes.empty() ? "the same but for noise"
                                        : fmt::format("{} differences beyond noise", changes.size()),
                        lost == 0 ? "" : fmt::format(", {} not compared", lost));
    for (std::size_t i = 0; i < std::min(changes.size(), kMost); ++i)
      text += fmt::format("  {} {}: {}, {} against {}\n", changes[i].requirement,
                          changes[i].target.empty() ? "all together" : changes[i].target,
                          quantity_name(changes[i].quantity), changes[i].after, changes[i].before);
    if (changes.size() > kMost) text += fmt::format("  and {} more\n", changes.size() - kMost);
  }
  return text;
}

}  // namespace orbs::history
