#include "studies/cost/report.h"

#include "base/text_table.h"
#include "studies/cost/numbers.h"
#include "studies/cost/other_load.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::studies {

namespace {

// The error in decibels that is nearest the target of the study.
std::size_t main_error(const CostRecord& record) {
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < error_targets().size(); ++i)
    if (error_targets()[i].metric == kPsnr &&
        std::fabs(error_targets()[i].level - record.settings.target_db) <
            std::fabs(error_targets()[nearest].level - record.settings.target_db))
      nearest = i;
  return nearest;
}

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

// "orbs is faster than cycles to 35 dB on 17 scenes, slower on 1, ...; cycles takes 2.08 times as long (1.83
// to 2.37; geometric mean of 10)".
std::string ranking(const CostRecord& record, const CostNumbers& numbers, std::size_t error) {
  struct Tally {
    std::map<Ranking, int> scenes;
    std::vector<double> logs;
  };
  std::map<std::pair<std::size_t, std::size_t>, Tally> tallies;
  const auto& wanted = error_targets().at(error);
  for (const auto& one : numbers.comparisons) {
    if (one.error != wanted) continue;
    auto& tally = tallies[{one.first, one.second}];
    ++tally.scenes[one.ranking];
    if (one.time_ratio) tally.logs.push_back(std::log(one.time_ratio->value));
  }
  std::string text;
  for (auto& [pair, tally] : tallies) {
    text += fmt::format(
        "{} is faster than {} to {} on {} scenes, slower on {}, no difference shown on {}, not comparable on {}",
        record.renderers[pair.first].name, record.renderers[pair.second].name, error_text(wanted),
        tally.scenes[Ranking::Slower],  // the ranking is of the second
        tally.scenes[Ranking::Faster], tally.scenes[Ranking::NoDifferenceShown],
        tally.scenes[Ranking::NotComparable]);
    // The interval of two ratios has one degree of freedom: "0.00 to 64000" says nothing.
    constexpr std::size_t kFewestRatios = 3;
    if (tally.logs.size() >= kFewestRatios) {
      const auto mean = mean_interval(tally.logs);
      text += fmt::format("; {} takes {:.2f} times as long ({:.2f} to {:.2f}; geometric mean of {})",
                          record.renderers[pair.second].name, std::exp(mean.value), std::exp(mean.low),
                          std::exp(mean.high), tally.logs.size());
    }
    text += "\n";
  }
  return text;
}

std::string self_text(const CostRecord& record, const CostNumbers& numbers) {
  const auto& found = numbers.self_comparison;
  if (!found) return "no renderer was compared with itself, so nothing is ranked: it needs two seeds\n";
  return fmt::format(
      "{} twice on {}: time {:.3f} ({:.3f} to {:.3f}), error {:.3f} ({:.3f} to {:.3f}): {}\n",
      record.renderers[found->renderer].name, record.targets[found->target].name, found->time_ratio.value,
      found->time_ratio.low, found->time_ratio.high, found->error_ratio.value, found->error_ratio.low,
      found->error_ratio.high,
      found->passed ? "no difference, as it must be"
      : !found->is_known
          ? "too uncertain to show anything, so nothing is ranked: more seeds are needed"
          : "a difference where there is none: the machine was not steady, and nothing is ranked");
}

std::string floors_text(const CostRecord& record, const CostNumbers& numbers) {
  std::string text;
  for (const auto& curve : numbers.curves) {
    if (!curve.fit || !curve.fit->has_floor) continue;
    const auto& [named, bias] = std::tie(curve.fit->floor_named, curve.fit->bias_squared);
    text += fmt::format("{} on {}: no time brings the relMSE below {:.2g} ({:.2g} to {:.2g}){}{}\n",
                        record.renderers[curve.renderer].name, record.targets[curve.target].name, bias.value,
                        bias.low, bias.high, named.empty() ? "" : ": ", named);
  }
  return text;
}

std::string notes_text(const CostRecord& record) {
  std::string text;
  for (const auto& sweep : record.sweeps)
    if (!sweep.note.empty())
      text += fmt::format("{} on {}: {}\n", record.renderers[sweep.renderer].name,
                          record.targets[sweep.target].name, sweep.note);
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
  return fmt::format("fixed cost of a render (in every time above; median of the scenes): {}\n",
                     fmt::join(parts, ", "));
}

std::string conditions(const CostRecord& record) {
  return fmt::format(
             "{} cores of {}, {} threads a render, load {:.1f} to {:.1f}; {} seeds a setting, size {}{}\n",
             record.host.cores, record.host.cpu, record.settings.threads, record.load, record.load_end,
             record.settings.seeds, record.size, record.is_finished ? "" : "; interrupted") +
         other_load_text(other_load_of(record));
}

}  // namespace

std::string cost_table(const CostRecord& record) {
  const auto numbers = cost_numbers(record);
  const auto error = main_error(record);
  return fmt::format("{}\n{}\n{}{}{}{}{}", text_table(time_rows(record, numbers, error)),
                     self_text(record, numbers), ranking(record, numbers, error), fixed_text(record, numbers),
                     floors_text(record, numbers), notes_text(record), conditions(record));
}

std::string cost_markdown(const CostRecord& record) {
  const auto numbers = cost_numbers(record);
  std::string text;
  for (std::size_t error = 0; error < error_targets().size(); ++error)
    text += fmt::format("{}\n{}\n", markdown_table(time_rows(record, numbers, error)),
                        ranking(record, numbers, error));
  return fmt::format("{}{}\n{}\n{}", text, self_text(record, numbers), fixed_text(record, numbers),
                     conditions(record));
}

}  // namespace orbs::studies
