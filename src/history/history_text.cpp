#include "history/history_text.h"

#include "base/text_table.h"
#include "history/change_colours.h"
#include "history/steps.h"
#include "results/state_colour.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::history {

namespace {

std::optional<double> median_of(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const auto middle = values.size() / 2;
  if (values.size() % 2 == 1 || std::isinf(values[middle])) return values[middle];
  return (values[middle - 1] + values[middle]) / 2;
}

std::string number_text(const std::optional<double>& value) {
  if (!value) return "-";
  return std::isinf(*value) ? "inf" : fmt::format("{:.2f}", *value);
}

std::vector<TableRow> step_rows(const std::vector<Change>& steps) {
  std::vector<TableRow> rows{{"", "renderer", "target", "", "before", "after", "by chance", "since"}};
  for (const auto& step : steps)
    rows.push_back({direction_name(step.direction), step.renderer,
                    step.target.empty() ? "all together" : step.target, quantity_name(step.quantity),
                    step.before, step.after, chance_text(step), step.since});
  return rows;
}

constexpr std::size_t kNow = 3;  // column of the newest verdict in target_rows

std::vector<TableRow> target_rows(const History& history) {
  std::vector<TableRow> rows{
      {"", "renderer", "target", "now", "dB", "median", "CPU s", "median", "runs with each verdict"}};
  for (const auto& series : history.series) {
    const auto summary = summary_of(series);
    rows.push_back({series.requirement, series.renderer, series.target, summary.now,
                    number_text(summary.newest_db), number_text(summary.median_db),
                    number_text(summary.newest_seconds), number_text(summary.median_seconds),
                    summary.states + (summary.is_flaky ? "; flaky" : "")});
  }
  return rows;
}

// The same on narrow terminals: what is the newest verdict stands among the counts.
std::vector<TableRow> narrow_target_rows(const History& history) {
  auto rows = target_rows(history);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    auto& row = rows[i];
    const auto counts = fmt::format(", {}", row.back());
    if (i > 0 && row.back().find(',') != std::string::npos) {
      const auto newest = counts.find(fmt::format(", {} ", row[kNow]));
      const auto end = std::min(counts.find_first_of(",;", newest + 2), counts.size());
      row.back().insert(end - 2, " (now)");
    }
    row.erase(row.begin() + kNow);
  }
  rows.front().back() = "verdicts";
  return rows;
}

// Of the newest verdict of each target, and of how steady it was.
CellColours state_colours(const History& history,
                          std::size_t now,
                          std::size_t last,
                          const TerminalStyle& style) {
  CellColours colours;
  if (!style.colour) return colours;
  for (std::size_t i = 0; i < history.series.size(); ++i) {
    const auto& series = history.series[i];
    if (series.points.empty()) continue;
    if (is_flaky(series)) colours[{i + 1, last}] = colour::kYellow;
    const auto& newest = series.points.back();
    colours[{i + 1, now}] = results::state_colour(newest.verdict, newest.expectation);
  }
  return colours;
}

std::string target_table(const History& history, const TerminalStyle& style) {
  auto rows = target_rows(history);
  const auto last = rows.front().size() - 1;
  if (fits(rows, style.width))
    return text_table(rows, {}, {style.width, state_colours(history, kNow, last, style)});
  return text_table(narrow_target_rows(history), {},
                    {style.width, state_colours(history, last - 1, last - 1, style)});
}

std::vector<std::string> remarks(const History& history) {
  std::vector<std::string> lines;
  if (const auto flaky = flaky_targets(history); !flaky.empty())
    lines.push_back(fmt::format("flaky (the verdict differs between seeds): {}", fmt::join(flaky, ", ")));
  lines.push_back(fmt::format("Steps need {} runs; of equal programs, 1 history in {:.0f} shows any step.",
                              kFewestRuns, 1 / kFalseAlarms));
  lines.insert(lines.end(), history.notes.begin(), history.notes.end());
  return lines;
}

}  // namespace

SeriesSummary summary_of(const Series& series) {
  SeriesSummary summary;
  std::map<std::string, int> counts;
  std::vector<double> decibels, seconds;
  for (const auto& point : series.points) {
    summary.now = state_name(point.verdict, point.expectation);
    ++counts[summary.now];
    if (point.psnr_db) decibels.push_back(*point.psnr_db);
    if (point.cpu_seconds) seconds.push_back(*point.cpu_seconds);
    summary.newest_db = point.psnr_db;
    summary.newest_seconds = point.cpu_seconds;
  }
  for (const auto& [state, count] : counts)
    summary.states += fmt::format("{}{} {}", summary.states.empty() ? "" : ", ", state, count);
  summary.is_flaky = is_flaky(series);
  summary.median_db = median_of(decibels);
  summary.median_seconds = median_of(seconds);
  return summary;
}

std::string headline(const History& history) {
  const auto count = history.runs.size();
  return fmt::format("{} run{} of suite {} at size {}, {} to {}", count, count == 1 ? "" : "s", history.suite,
                     history.size, history.runs.front().started, history.runs.back().started);
}

std::vector<std::string> flaky_targets(const History& history) {
  std::set<std::string> names;
  for (const auto& series : history.series)
    if (is_flaky(series)) names.insert(series.renderer + " " + series.target);
  return {names.begin(), names.end()};
}

std::string history_text(const History& history,
                         const std::vector<Change>& steps,
                         const TerminalStyle& style) {
  std::string text;
  const auto add = [&](const std::string& line) { text += wrapped_lines(line + '\n', style.width); };
  add(headline(history));
  text += '\n';
  if (!steps.empty())
    text += text_table(step_rows(steps), {}, {style.width, direction_colours(steps, style)}) + "\n";
  text += target_table(history, style) + "\n";
  for (const auto& line : remarks(history)) add(line);
  return text;
}

std::string history_markdown(const History& history, const std::vector<Change>& steps) {
  auto text = headline(history) + "\n\n";
  if (!steps.empty()) text += markdown_table(step_rows(steps)) + "\n";
  text += markdown_table(target_rows(history)) + "\n";
  for (const auto& line : remarks(history)) text += fmt::format("- {}\n", line);
  return text;
}

}  // namespace orbs::history
