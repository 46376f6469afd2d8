#include "studies/cost/prices.h"

#include "studies/cost/points.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

// A point in the terms of a goal: a squared error that gets less with time.
struct Step {
  double error = 0;
  double seconds = 0;  // of CPU, the fixed cost included
  double error_log_variance = 0;
  double time_log_variance = 0;
};

double log_variance_of(const Interval& seconds, int renders) {
  if (renders < 2 || !(seconds.low > 0)) return 0;
  // The range of n normally distributed values is about sqrt(n) deviations for small n (Tippett 1925: 2.06
  // for n = 4), and the median of n varies by pi / 2 of the variance over n.
  const double deviation = std::log(seconds.high / seconds.low) / std::sqrt(static_cast<double>(renders));
  return deviation * deviation * 1.5707963 / renders;
}

std::vector<Step> steps_of(const CostCurve& curve, std::size_t metric) {
  std::vector<Step> steps;
  for (const auto& point : curve.points) {
    const auto& error = point.errors.at(metric);
    if (!error) continue;
    // Less than the noise of the reference, which was subtracted, is no error that is left.
    const double value = std::max(0.0, metric == kPsnr ? mse_of_psnr(error->value) : error->value);
    steps.push_back({value, point.cpu_seconds.value, curve.relative_variance / point.renders,
                     log_variance_of(point.cpu_seconds, point.renders)});
  }
  std::sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) { return a.seconds < b.seconds; });
  return steps;
}

void set_interval(CostPrice& price, double seconds, double log_variance, double degrees) {
  price.log_error = std::sqrt(log_variance);
  price.degrees = std::max(1.0, degrees);
  const auto logs = student_interval(std::log(seconds), price.log_error, price.degrees, kOutside);
  price.cpu_seconds = Interval{std::exp(logs.value), std::exp(logs.low), std::exp(logs.high)};
}

// Between two rungs that enclose the goal.
void interpolate(
    CostPrice& price, const Step& before, const Step& after, double goal, double fixed, double degrees) {
  const double t0 = std::log(before.seconds - fixed);
  const double t1 = std::log(after.seconds - fixed);
  const double e0 = std::log(before.error);
  const double e1 = std::log(after.error);
  const double share = (e0 - std::log(goal)) / (e0 - e1);
  const double variable = std::exp(t0 + share * (t1 - t0));
  // An error of the logarithm of the error moves the crossing along the slope.
  const double slope = (t1 - t0) / (e0 - e1);
  const double moved =
      slope * slope *
      ((1 - share) * (1 - share) * before.error_log_variance + share * share * after.error_log_variance);
  const double timed = (1 - share) * before.time_log_variance + share * after.time_log_variance;
  // Only the part above the fixed cost moves with the error.
  const double weight = variable / (variable + fixed);
  set_interval(price, variable + fixed, weight * weight * moved + timed, degrees);
}

}  // namespace

CostPrice cost_price(const CostCurve& curve, const CostGoal& goal, bool has_samples) {
  CostPrice price{goal, {}, {}, {}};
  const double level = goal.metric == kPsnr ? mse_of_psnr(goal.level) : goal.level;
  const auto steps = steps_of(curve, goal.metric);
  if (steps.empty()) {
    price.note = "not measured";
    return price;
  }
  const auto reached =
      std::find_if(steps.begin(), steps.end(), [&](const Step& step) { return step.error <= level; });
  if (reached == steps.end()) {
    price.at_least = steps.back().seconds;
    price.note = fmt::format("not reached: more than {:.3g} s", *price.at_least);
    return price;
  }
  const double fixed = curve.fixed_cpu_seconds.value;
  if (!has_samples || reached->error <= 0) {
    set_interval(price, reached->seconds, reached->time_log_variance, curve.degrees);
  } else if (reached == steps.begin()) {
    price.note = fmt::format("the first rung reaches it: at most {:.3g} s", reached->seconds);
  } else if (!(std::prev(reached)->seconds > fixed) || !(std::prev(reached)->error > reached->error)) {
    price.note = "too short to be told from the fixed cost";
  } else {
    interpolate(price, *std::prev(reached), *reached, level, fixed, curve.degrees);
  }
  return price;
}

void set_prices(CostCurve& curve, bool has_samples) {
  curve.prices.clear();
  for (const auto& goal : cost_goals()) curve.prices.push_back(cost_price(curve, goal, has_samples));
  const CostPoint* best = nullptr;  // the last that the reference can still judge
  const CostPoint* before = nullptr;
  for (const auto& point : curve.points) {
    if (point.is_below_reference_noise || !point.errors[kRelmse] || !(point.errors[kRelmse]->value > 0))
      continue;
    if (!seconds_above_fixed(curve, point)) continue;
    before = best;
    best = &point;
  }
  if (best == nullptr) return;
  const double error = best->errors[kRelmse]->value;
  const double error_log_variance = curve.relative_variance / best->renders;
  const double log_error = std::sqrt(error_log_variance + log_variance_of(best->cpu_seconds, best->renders));
  const auto efficiency =
      student_interval(-std::log(error * best->cpu_seconds.value), log_error, curve.degrees, kOutside);
  curve.efficiency =
      Interval{std::exp(efficiency.value), std::exp(efficiency.low), std::exp(efficiency.high)};
  if (before == nullptr || !has_samples) return;
  const double decibels = 10 * std::log10(before->errors[kRelmse]->value / error);
  if (!(decibels > 0)) return;
  const double factor = std::log(*seconds_above_fixed(curve, *best) / *seconds_above_fixed(curve, *before));
  const double decibels_error =
      10 / std::log(10.0) * std::sqrt(error_log_variance + curve.relative_variance / before->renders);
  const auto slope = student_interval(factor / decibels, factor / decibels * decibels_error / decibels,
                                      curve.degrees, kOutside);
  curve.seconds_per_db = Interval{std::expm1(slope.value), std::expm1(slope.low), std::expm1(slope.high)};
}

}  // namespace orbs::studies
