#include "studies/cost/numbers.h"

#include <cmath>

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

// Welch's degrees for the difference of two logarithms.
Interval ratio_of(const TimeToError& first, const TimeToError& second) {
  const double a = first.log_error * first.log_error;
  const double b = second.log_error * second.log_error;
  const double squares = a * a / first.degrees + b * b / second.degrees;
  const double degrees = squares > 0 ? (a + b) * (a + b) / squares : 1;
  const auto logs = student_interval(std::log(second.cpu_seconds->value / first.cpu_seconds->value),
                                     std::sqrt(a + b), degrees, kOutside);
  return {std::exp(logs.value), std::exp(logs.low), std::exp(logs.high)};
}

// One reaches the error and the other does not: whether the bound of the other lies beyond the interval.
bool is_surely_faster(const TimeToError& reached, const TimeToError& missed) {
  return missed.bound == Bound::AtLeast && missed.bound_seconds > reached.cpu_seconds->high;
}

CostComparison compare_times(const TimeToError& first, const TimeToError& second) {
  CostComparison out;
  out.error = first.target;
  if (first.cpu_seconds && second.cpu_seconds) {
    out.time_ratio = ratio_of(first, second);
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

// The renders of the setting that was rendered again, against those of the setting: the same renderer under
// two names. Nothing while there are less than two of each.
std::optional<SelfComparison> compare_with_itself(const CostRecord& record) {
  for (std::size_t sweep = 0; sweep < record.sweeps.size(); ++sweep) {
    const auto again = renders_of(record, record.sweeps[sweep], Purpose::Again);
    if (again.size() < 2) continue;
    const auto first = renders_of(record, record.sweeps[sweep], Purpose::Sweep, again.front()->setting);
    if (first.size() < 2) continue;
    std::vector<double> times, times_again, errors, errors_again;
    for (const auto* render : first) {
      times.push_back(render->cpu_seconds);
      errors.push_back(render->relmse.value_or(0));
    }
    for (const auto* render : again) {
      times_again.push_back(render->cpu_seconds);
      errors_again.push_back(render->relmse.value_or(0));
    }
    SelfComparison found{record.sweeps[sweep].renderer, record.sweeps[sweep].target,
                         static_cast<int>(again.size()), ratio_interval(times, times_again, kSelfOutside),
                         ratio_interval(errors, errors_again, kSelfOutside)};
    found.is_known = is_known(found.time_ratio) && is_known(found.error_ratio);
    found.passed = found.is_known && holds_one(found.time_ratio) && holds_one(found.error_ratio);
    return found;
  }
  return std::nullopt;
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

}  // namespace

CostNumbers cost_numbers(const CostRecord& record) {
  CostNumbers numbers;
  for (std::size_t sweep = 0; sweep < record.sweeps.size(); ++sweep) {
    auto curve = cost_curve(record, sweep);
    set_times_to_error(curve, record.renderers.at(curve.renderer).sweep == SweepOf::Samples);
    numbers.curves.push_back(std::move(curve));
  }
  mark_frontier(numbers.curves);
  numbers.other_load = other_load_of(record);
  numbers.self_comparison = compare_with_itself(record);
  if (numbers.self_comparison && numbers.self_comparison->passed)
    numbers.comparisons = compare_renderers(numbers.curves);
  return numbers;
}

}  // namespace orbs::studies
