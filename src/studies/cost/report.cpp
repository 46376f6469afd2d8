#include "studies/cost/report.h"

#include "base/short_sentence.h"
#include "base/text_table.h"
#include "studies/cost/numbers.h"
#include "studies/cost/other_load.h"
#include "studies/cost/schedule.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::studies {

namespace {

constexpr std::size_t kMostColumns = 150;  // of a sentence in the terminal

const CostCurve* find_curve(const CostNumbers& numbers, std::size_t target, std::size_t renderer) {
  for (const auto& curve : numbers.curves)
    if (curve.target == target && curve.renderer == renderer && !curve.points.empty()) return &curve;
  return nullptr;
}

// One render says nothing of its interval.
std::string seconds_text(const Interval& seconds) {
  if (seconds.low == seconds.high) return fmt::format("{:.2g} s (one render)", seconds.value);
  return fmt::format("{:.2g} s ({:.2g}-{:.2g})", seconds.value, seconds.low, seconds.high);
}

std::string time_text(const CostCurve* curve, std::size_t error) {
  if (curve == nullptr) return "-";
  const auto& time = curve->times_to_error.at(error);
  switch (time.bound) {
    case Bound::Exact:
      return seconds_text(*time.cpu_seconds);
    case Bound::AtMost:
      return fmt::format("< {:.2g} s", time.bound_seconds);
    case Bound::AtLeast:
      return fmt::format("> {:.2g} s", time.bound_seconds);
    case Bound::Unknown:
      return "?";
  }
  return {};
}

std::vector<TableRow> time_rows(const CostRecord& record, const CostNumbers& numbers, std::size_t error) {
  TableRow head{"", fmt::format("CPU time to {}", error_text(error_targets().at(error)))};
  for (const auto& renderer : record.renderers)
    head.push_back(renderer.biased.empty() ? renderer.name
                                           : fmt::format("{} ({})", renderer.name, renderer.biased));
  std::vector<TableRow> rows{head};
  for (std::size_t target = 0; target < record.targets.size(); ++target) {
    TableRow row{record.targets[target].requirement, record.targets[target].name};
    for (std::size_t renderer = 0; renderer < record.renderers.size(); ++renderer)
      row.push_back(time_text(find_curve(numbers, target, renderer), error));
    rows.push_back(row);
  }
  return rows;
}

// Whether the renderer is shown to be faster on the scene than another one, and than all that it can be
// compared with.
bool is_fastest(const CostNumbers& numbers, std::size_t target, std::size_t renderer, std::size_t error) {
  bool is_faster = false;
  for (const auto& one : numbers.comparisons) {
    if (one.target != target || one.error != error_targets().at(error) ||
        (one.first != renderer && one.second != renderer) || one.ranking == Ranking::NotComparable)
      continue;
    if (one.ranking != (one.second == renderer ? Ranking::Faster : Ranking::Slower)) return false;
    is_faster = true;
  }
  return is_faster;
}

CellColours time_colours(const CostRecord& record,
                         const CostNumbers& numbers,
                         std::size_t error,
                         const TerminalStyle& style) {
  constexpr std::size_t kBefore = 2;  // columns of time_rows before the renderers
  CellColours colours;
  if (!style.colour) return colours;
  for (std::size_t target = 0; target < record.targets.size(); ++target)
    for (std::size_t renderer = 0; renderer < record.renderers.size(); ++renderer) {
      const auto* curve = find_curve(numbers, target, renderer);
      const bool has_time = curve != nullptr && curve->times_to_error.at(error).bound == Bound::Exact;
      if (!has_time)
        colours[{target + 1, kBefore + renderer}] = colour::kFaint;
      else if (is_fastest(numbers, target, renderer, error))
        colours[{target + 1, kBefore + renderer}] = colour::kGreen;
    }
  return colours;
}

// "orbs is faster than cycles to 35 dB on 17 scenes, slower on 1, ...; cycles takes 2.08 (1.83 to
// 2.37) times as long (geometric mean of 10)".
std::string ranking(const CostRecord& record, const CostNumbers& numbers, std::size_t error) {
  std::map<std::pair<std::size_t, std::size_t>, std::map<Ranking, int>> tallies;
  const auto& wanted = error_targets().at(error);
  for (const auto& one : numbers.comparisons)
    if (one.error == wanted) ++tallies[{one.first, one.second}][one.ranking];
  std::string text;
  for (auto& [pair, scenes] : tallies) {
    text += fmt::format(
        "{} is faster than {} to {} on {} scenes, slower on {}, no difference shown on {}, not comparable on {}",
        record.renderers[pair.first].name, record.renderers[pair.second].name, error_text(wanted),
        scenes[Ranking::Slower],  // the ranking is of the second
        scenes[Ranking::Faster], scenes[Ranking::NoDifferenceShown], scenes[Ranking::NotComparable]);
    for (const auto& mean : numbers.mean_ratios)
      if (mean.error == wanted && mean.first == pair.first && mean.second == pair.second)
        text += fmt::format("; {} takes {} times as long (geometric mean of {})",
                            record.renderers[pair.second].name, ratio_text(mean.time_ratio), mean.scenes);
    text += "\n";
  }
  return text;
}

std::string self_verdict(const SelfComparison& found) {
  if (found.passed) return "no difference, as it must be";
  return found.is_known
             ? "a difference where there is none: the machine was not steady, and nothing is ranked"
             : "too uncertain to show anything, so nothing is ranked: more seeds are needed";
}

std::string self_text(const CostRecord& record, const CostNumbers& numbers) {
  const auto& found = numbers.self_comparison;
  if (!found)
    return "no renderer was compared with itself, so nothing is ranked: that needs two undisturbed "
           "renders of a setting, and two of it again\n";
  const auto scenes = found->scenes.size();
  auto text =
      fmt::format("{} twice on {} scene{}: time {}, error {}: {}\n", record.renderers[found->renderer].name,
                  scenes, scenes == 1 ? "" : "s", ratio_text(found->time_ratio),
                  ratio_text(found->error_ratio), self_verdict(*found));
  if (scenes > 1)
    text += fmt::format(
        "ratios of single scenes: time {:.3f} to {:.3f}, scatter {:.1f} %; error {:.3f} to {:.3f}, scatter "
        "{:.1f} %; {} of them differ at a level of 1 %\n",
        found->time_spread.least, found->time_spread.most, 100 * found->time_scatter,
        found->error_spread.least, found->error_spread.most, 100 * found->error_scatter, found->differing);
  return text;
}

std::string floors_text(const CostRecord& record, const CostNumbers& numbers, bool is_short) {
  std::string text;
  for (const auto& curve : numbers.curves) {
    if (!curve.fit || !curve.fit->has_floor) continue;
    const auto& [named, bias] = std::tie(curve.fit->floor_named, curve.fit->bias_squared);
    text += fmt::format("{} on {}: no time brings the relMSE below {:.2g} ({:.2g} to {:.2g}){}{}\n",
                        record.renderers[curve.renderer].name, record.targets[curve.target].name, bias.value,
                        bias.low, bias.high, named.empty() ? "" : ": ",
                        is_short ? short_sentence(named, kMostColumns) : named);
  }
  return text;
}

std::string notes_text(const CostRecord& record) {
  auto text = unmeasured_summary(record);
  for (const auto& sweep : record.sweeps)
    for (const auto& note : {sweep.note, unmeasured_text(record, sweep)})
      if (!note.empty())
        text += fmt::format("{} on {}: {}\n", record.renderers[sweep.renderer].name,
                            record.targets[sweep.target].name, note);
  return text;
}

std::string fixed_text(const CostRecord& record, const CostNumbers& numbers) {
  std::vector<std::string> parts;
  for (std::size_t renderer = 0; renderer < record.renderers.size(); ++renderer) {
    std::vector<double> seconds;
    for (const auto& curve : numbers.curves)
      if (curve.renderer == renderer && !curve.points.empty() && curve.fixed_cpu_seconds)
        seconds.push_back(curve.fixed_cpu_seconds->value);
    if (!seconds.empty())
      parts.push_back(
          fmt::format("{} {:.2g} s", record.renderers[renderer].name, median_interval(seconds).value));
  }
  if (parts.empty()) return "";
  return fmt::format("fixed cost of a render (in every time above; median of the scenes): {}\n",
                     fmt::join(parts, ", "));
}

std::string part_text(const std::optional<Interval>& seconds) {
  return seconds ? seconds_text(*seconds) : "-";
}

// Of what the time of a render is made, at the last setting of each curve. Nothing while there is none.
std::vector<TableRow> part_rows(const CostRecord& record, const CostNumbers& numbers) {
  std::vector<TableRow> rows{
      {"", "renderer", "last setting", "start (CPU)", "trials", "own render time", "CPU time, all"}};
  for (const auto& curve : numbers.curves) {
    if (curve.points.empty()) continue;
    const auto& last = curve.points.back();
    rows.push_back({record.targets[curve.target].name, record.renderers[curve.renderer].name,
                    last.setting.name, part_text(curve.fixed_cpu_seconds), part_text(last.trial_seconds),
                    part_text(last.render_seconds), seconds_text(last.cpu_seconds)});
  }
  if (rows.size() == 1) rows.clear();
  return rows;
}

std::string conditions(const CostRecord& record) {
  return fmt::format(
             "{} cores of {}, {} threads a render, load {:.1f} to {:.1f}; {} seeds a setting, size {}{}\n",
             record.host.cores, record.host.cpu, record.settings.threads, record.load, record.load_end,
             record.settings.seeds, record.size, record.is_finished ? "" : "; interrupted") +
         other_load_text(other_load_of(record));
}

// The unit is in the head, and a renderer that is biased has a mark there, so that the columns are narrow.
std::vector<TableRow> narrow_time_rows(const CostRecord& record,
                                       const CostNumbers& numbers,
                                       std::size_t error) {
  auto rows = time_rows(record, numbers, error);
  for (std::size_t i = 0; i < record.renderers.size(); ++i) {
    const auto& renderer = record.renderers[i];
    rows.front()[rows.front().size() - record.renderers.size() + i] =
        renderer.name + (renderer.biased.empty() ? "" : " *");
  }
  rows.front()[1] = fmt::format("CPU s to {}", error_text(error_targets().at(error)));
  for (auto row = rows.begin() + 1; row != rows.end(); ++row)
    for (std::size_t i = 2; i < row->size(); ++i)
      if (const auto unit = (*row)[i].find(" s"); unit != std::string::npos) (*row)[i].erase(unit, 2);
  return rows;
}

std::string legend(const CostRecord& record, const TerminalStyle& style) {
  std::string text =
      "> the error is not reached in that time; < it is reached sooner; ? the renders do not "
      "tell; - not rendered";
  if (style.colour) text += "; green is faster than all that it can be compared with";
  text += '\n';
  for (const auto& renderer : record.renderers)
    if (!renderer.biased.empty()) text += fmt::format("* {}: {}\n", renderer.name, renderer.biased);
  return text;
}

std::string median_text(const std::optional<Interval>& seconds) {
  return seconds ? fmt::format("{:.2g}", seconds->value) : "-";
}

// The same rows in 80 columns: seconds, and no intervals.
std::vector<TableRow> narrow_part_rows(const CostRecord& record, const CostNumbers& numbers) {
  std::vector<TableRow> rows{{"", "renderer", "setting", "start", "trials", "own", "all"}};
  for (const auto& curve : numbers.curves) {
    if (curve.points.empty()) continue;
    const auto& last = curve.points.back();
    rows.push_back({record.targets[curve.target].name, record.renderers[curve.renderer].name,
                    last.setting.name, median_text(curve.fixed_cpu_seconds), median_text(last.trial_seconds),
                    median_text(last.render_seconds), median_text(last.cpu_seconds)});
  }
  return rows;
}

std::string part_table(const CostRecord& record, const CostNumbers& numbers, const TerminalStyle& style) {
  const auto rows = part_rows(record, numbers);
  if (rows.empty()) return "";
  std::string title = "Parts of the time of a render at the last setting";
  if (fits(rows, style.width)) return fmt::format("\n{}\n{}", title, text_table(rows));
  title +=
      ", in seconds: starting (CPU), trial renderings, the renderer's own statement, and all CPU time; "
      "--markdown has the intervals\n";
  return fmt::format("\n{}{}", wrapped_lines(title, style.width),
                     text_table(narrow_part_rows(record, numbers), {}, {style.width, {}}));
}

// Scenes of a renderer whose notes begin with the same sentence.
struct SharedNote {
  std::size_t renderer = 0;
  std::string sentence, whole;  // no whole note where they go on differently
  std::vector<std::string> scenes;
};

void take_in(std::vector<SharedNote>& notes,
             const CostRecord& record,
             const Sweep& sweep,
             const std::string& note) {
  if (note.empty()) return;
  const auto sentence = short_sentence(note, kMostColumns);
  const auto& scene = record.targets[sweep.target].name;
  const auto same = std::find_if(notes.begin(), notes.end(), [&](const SharedNote& one) {
    return one.renderer == sweep.renderer && one.sentence == sentence;
  });
  if (same == notes.end()) {
    notes.push_back({sweep.renderer, sentence, note, {scene}});
    return;
  }
  same->scenes.push_back(scene);
  if (same->whole != note) same->whole.clear();
}

// The notes of many scenes are told once, as far as they are the same: the Markdown has them all.
std::string shared_notes(const CostRecord& record) {
  std::vector<SharedNote> notes;
  for (const auto& sweep : record.sweeps)
    for (const auto& note : {sweep.note, unmeasured_text(record, sweep)}) take_in(notes, record, sweep, note);
  auto text = unmeasured_summary(record);
  for (const auto& note : notes)
    text += fmt::format("{} on {}: {}\n", record.renderers[note.renderer].name, fmt::join(note.scenes, ", "),
                        note.whole.empty() ? note.sentence : note.whole);
  return text;
}

}  // namespace

std::string ratio_text(const Interval& ratio) {
  return fmt::format("{:.3g} ({:.3g} to {:.3g})", ratio.value, ratio.low, ratio.high);
}

std::string cost_table(const CostRecord& record, const TerminalStyle& style) {
  const auto numbers = cost_numbers(record);
  const auto error = main_error(record);
  const auto* self_colour =
      numbers.self_comparison && numbers.self_comparison->passed ? &colour::kGreen : &colour::kRed;
  const auto self = self_text(record, numbers);
  const auto first_end = self.find('\n');
  return text_tables(narrow_time_rows(record, numbers, error), 2,
                     {style.width, time_colours(record, numbers, error, style)}) +
         wrapped_lines(legend(record, style), style.width) + part_table(record, numbers, style) + '\n' +
         painted(wrapped_lines(self.substr(0, first_end), style.width), *self_colour, style) +
         wrapped_lines(self.substr(first_end + 1) + ranking(record, numbers, error) +
                           fixed_text(record, numbers) + floors_text(record, numbers, true) +
                           shared_notes(record) + conditions(record),
                       style.width);
}

std::string cost_markdown(const CostRecord& record) {
  const auto numbers = cost_numbers(record);
  std::string text;
  for (std::size_t error = 0; error < error_targets().size(); ++error)
    text += fmt::format("{}\n{}\n", markdown_table(time_rows(record, numbers, error)),
                        ranking(record, numbers, error));
  return fmt::format("{}{}\n{}\n{}\n{}\n{}", text, self_text(record, numbers), fixed_text(record, numbers),
                     markdown_table(part_rows(record, numbers)), notes_text(record), conditions(record));
}

}  // namespace orbs::studies
