#include "studies/cost/numbers.h"

#include "studies/cost/schedule.h"
#include "studies/cost/seeds.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace orbs::studies {

namespace {

// A point is on the frontier when no other of its target is both faster and better.
void mark_frontier(std::vector<CostCurve>& curves) {
  for (auto& curve : curves)
    for (auto& point : curve.points) {
      if (!point.errors[kRelmse]) continue;
      point.is_on_frontier = true;
      for (const auto& other : curves) {
        if (other.target != curve.target) continue;
        for (const auto& rival : other.points)
          if (rival.errors[kRelmse] && rival.cpu_seconds.value < point.cpu_seconds.value &&
              rival.errors[kRelmse]->value <= point.errors[kRelmse]->value)
            point.is_on_frontier = false;
      }
    }
}

constexpr double kSelfOutside =
    0.01;  // the share of equal pairs that are called different, for time and error

// A check that could not see a factor of two says nothing.
bool is_known(const Interval& ratio) { return ratio.high < 2 * ratio.low; }

bool holds_one(const Interval& ratio) { return ratio.low <= 1 && 1 <= ratio.high; }

// One reaches the error and the other does not: whether the bound of the other lies beyond the interval.
bool is_surely_faster(const TimeToError& reached, const TimeToError& missed) {
  return missed.bound == Bound::AtLeast && missed.bound_seconds > reached.cpu_seconds->high;
}

CostComparison compare_times(const TimeToError& first, const TimeToError& second) {
  CostComparison out;
  out.error = first.target;
  if (first.cpu_seconds && second.cpu_seconds) {
    out.time_ratio = ratio_interval(log_ratio_of(first, second));
    out.ranking = holds_one(*out.time_ratio)  ? Ranking::NoDifferenceShown
                  : out.time_ratio->value > 1 ? Ranking::Slower
                                              : Ranking::Faster;
  } else if (first.cpu_seconds && is_surely_faster(first, second)) {
    out.ranking = Ranking::Slower;
  } else if (second.cpu_seconds && is_surely_faster(second, first)) {
    out.ranking = Ranking::Faster;
  }
  return out;
}

struct SelfLogs {
  std::vector<LogRatio> times, errors;
};

// The renders of the setting that was rendered again, against those of the setting. Nothing while there are
// less than two of each.
std::optional<SelfScene> compare_scene(const CostRecord& record, const Sweep& sweep, SelfLogs& logs) {
  const auto again = renders_of(record, sweep, Purpose::Again);
  if (again.size() < 2) return std::nullopt;
  const auto first = renders_of(record, sweep, Purpose::Sweep, again.front()->setting);
  if (first.size() < 2) return std::nullopt;
  std::vector<double> times, times_again, errors, errors_again;
  for (const auto* render : first) {
    times.push_back(render->cpu_seconds);
    errors.push_back(render->relmse.value_or(0));
  }
  for (const auto* render : again) {
    times_again.push_back(render->cpu_seconds);
    errors_again.push_back(render->relmse.value_or(0));
  }
  logs.times.push_back(log_ratio(times, times_again));
  logs.errors.push_back(log_ratio(errors, errors_again));
  return SelfScene{sweep.target, static_cast<int>(again.size()),
                   ratio_interval(logs.times.back(), kSelfOutside),
                   ratio_interval(logs.errors.back(), kSelfOutside)};
}

Spread ratio_spread(const std::vector<LogRatio>& logs, double& scatter) {
  std::vector<double> values, ratios;
  for (const auto& log : logs) {
    values.push_back(log.value);
    ratios.push_back(std::exp(log.value));
  }
  scatter = std::sqrt(sample_of(values).variance);
  return spread_of(ratios).value_or(Spread{});
}

// The same renderer under two names, on every scene on which it was rendered again.
std::optional<SelfComparison> compare_with_itself(const CostRecord& record) {
  SelfComparison found;
  SelfLogs logs;
  for (const auto& sweep : record.sweeps)
    if (const auto scene = compare_scene(record, sweep, logs)) {
      found.renderer = sweep.renderer;
      found.scenes.push_back(*scene);
      if (!holds_one(scene->time_ratio) || !holds_one(scene->error_ratio)) ++found.differing;
    }
  if (found.scenes.empty()) return std::nullopt;
  found.time_ratio = ratio_interval(mean_within(logs.times), kSelfOutside);
  found.error_ratio = ratio_interval(mean_within(logs.errors), kSelfOutside);
  found.time_spread = ratio_spread(logs.times, found.time_scatter);
  found.error_spread = ratio_spread(logs.errors, found.error_scatter);
  found.is_known = is_known(found.time_ratio) && is_known(found.error_ratio);
  found.passed = found.is_known && holds_one(found.time_ratio) && holds_one(found.error_ratio);
  return found;
}

// Every two renderers at every error of every target that both were measured on.
std::vector<CostComparison> compare_renderers(const std::vector<CostCurve>& curves) {
  std::vector<CostComparison> all;
  for (const auto& one : curves)
    for (const auto& other : curves) {
      if (one.target != other.target || one.renderer >= other.renderer) continue;
      for (std::size_t i = 0; i < error_targets().size(); ++i) {
        auto found = compare_times(one.times_to_error.at(i), other.times_to_error.at(i));
        found.target = one.target;
        found.first = one.renderer;
        found.second = other.renderer;
        all.push_back(found);
      }
    }
  return all;
}

// Of every two renderers at every error at which both arrive on some scene.
std::vector<MeanRatio> mean_ratios_of(const std::vector<CostCurve>& curves,
                                      const std::vector<CostComparison>& comparisons) {
  const auto time_of = [&](const CostComparison& one, std::size_t renderer) -> const TimeToError& {
    const auto curve = std::find_if(curves.begin(), curves.end(), [&](const CostCurve& other) {
      return other.target == one.target && other.renderer == renderer;
    });
    return *std::find_if(curve->times_to_error.begin(), curve->times_to_error.end(),
                         [&](const TimeToError& time) { return time.target == one.error; });
  };
  std::map<std::tuple<std::size_t, std::size_t, std::size_t, double>, std::vector<LogRatio>> logs;
  for (const auto& one : comparisons)
    if (one.time_ratio)
      logs[{one.first, one.second, one.error.metric, one.error.level}].push_back(
          log_ratio_of(time_of(one, one.first), time_of(one, one.second)));
  std::vector<MeanRatio> means;
  for (const auto& [key, own] : logs) {
    const auto& [first, second, metric, level] = key;
    means.push_back(
        {{metric, level}, first, second, static_cast<int>(own.size()), ratio_interval(mean_over(own))});
  }
  return means;
}

}  // namespace

LogRatio log_ratio_of(const TimeToError& first, const TimeToError& second) {
  return sum_of({{std::log(second.cpu_seconds->value), second.log_error * second.log_error, second.degrees},
                 {-std::log(first.cpu_seconds->value), first.log_error * first.log_error, first.degrees}});
}

std::size_t main_error(const CostRecord& record) {
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < error_targets().size(); ++i)
    if (error_targets()[i].metric == kPsnr &&
        std::fabs(error_targets()[i].level - record.settings.target_db) <
            std::fabs(error_targets()[nearest].level - record.settings.target_db))
      nearest = i;
  return nearest;
}

CostNumbers cost_numbers(const CostRecord& measured) {
  const auto record = with_times_of_one_image(measured);
  CostNumbers numbers;
  for (std::size_t sweep = 0; sweep < record.sweeps.size(); ++sweep) {
    auto curve = cost_curve(record, sweep);
    set_times_to_error(curve, record.renderers.at(curve.renderer).sweep == SweepOf::Samples);
    curve.unmeasured = unmeasured_text(record, record.sweeps[sweep]);
    numbers.curves.push_back(std::move(curve));
  }
  mark_frontier(numbers.curves);
  numbers.other_load = other_load_of(record);
  numbers.self_comparison = compare_with_itself(record);
  if (numbers.self_comparison && numbers.self_comparison->passed)
    numbers.comparisons = compare_renderers(numbers.curves);
  numbers.mean_ratios = mean_ratios_of(numbers.curves, numbers.comparisons);
  return numbers;
}

}  // namespace orbs::studies
