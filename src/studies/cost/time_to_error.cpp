#include "studies/cost/time_to_error.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

// A point in the terms of an error target: a squared error that gets less with time.
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

void set_interval(TimeToError& time, double seconds, double log_variance, double degrees) {
  time.bound = Bound::Exact;
  time.log_error = std::sqrt(log_variance);
  time.degrees = std::max(1.0, degrees);
  time.cpu_seconds = ratio_interval(LogRatio{std::log(seconds), log_variance, time.degrees});
}

// Between two sample counts whose errors enclose the target.
void interpolate(
    TimeToError& time, const Step& before, const Step& after, double target, double fixed, double degrees) {
  const double t0 = std::log(before.seconds - fixed);
  const double t1 = std::log(after.seconds - fixed);
  const double e0 = std::log(before.error);
  const double e1 = std::log(after.error);
  const double share = (e0 - std::log(target)) / (e0 - e1);
  const double variable = std::exp(t0 + share * (t1 - t0));
  // An error of the logarithm of the error moves the crossing along the slope.
  const double slope = (t1 - t0) / (e0 - e1);
  const double moved =
      slope * slope *
      ((1 - share) * (1 - share) * before.error_log_variance + share * share * after.error_log_variance);
  const double timed = (1 - share) * before.time_log_variance + share * after.time_log_variance;
  // Only the part above the fixed cost moves with the error.
  const double weight = variable / (variable + fixed);
  set_interval(time, variable + fixed, weight * weight * moved + timed, degrees);
}

}  // namespace

const std::vector<ErrorTarget>& error_targets() {
  static const std::vector<ErrorTarget> targets{{kPsnr, 30},     {kPsnr, 35},     {kPsnr, 40},    {kPsnr, 45},
                                                {kRelmse, 1e-2}, {kRelmse, 1e-3}, {kRelmse, 1e-4}};
  return targets;
}

std::string error_text(const ErrorTarget& target) {
  return target.metric == kPsnr ? fmt::format("{:g} dB", target.level)
                                : fmt::format("relMSE 1e{:.0f}", std::log10(target.level));
}

TimeToError time_to_error(const CostCurve& curve, const ErrorTarget& target, bool has_samples) {
  TimeToError time;
  time.target = target;
  const double level = target.metric == kPsnr ? mse_of_psnr(target.level) : target.level;
  const auto steps = steps_of(curve, target.metric);
  if (steps.empty()) return time;
  const auto reached =
      std::find_if(steps.begin(), steps.end(), [&](const Step& step) { return step.error <= level; });
  if (reached == steps.end()) {
    time.bound = Bound::AtLeast;
    time.bound_seconds = steps.back().seconds;
    return time;
  }
  const double fixed = fixed_seconds(curve);
  if (!has_samples || reached->error <= 0) {
    set_interval(time, reached->seconds, reached->time_log_variance, curve.degrees);
  } else if (reached == steps.begin()) {
    time.bound = Bound::AtMost;
    time.bound_seconds = reached->seconds;
  } else if (std::prev(reached)->seconds > fixed && std::prev(reached)->error > reached->error) {
    interpolate(time, *std::prev(reached), *reached, level, fixed, curve.degrees);
  }
  return time;
}

void set_times_to_error(CostCurve& curve, bool has_samples) {
  curve.times_to_error.clear();
  for (const auto& target : error_targets())
    curve.times_to_error.push_back(time_to_error(curve, target, has_samples));
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
  const double log_variance = error_log_variance + log_variance_of(best->cpu_seconds, best->renders);
  curve.efficiency = ratio_interval(
      LogRatio{-std::log(error * best->cpu_seconds.value), log_variance, std::max(1.0, curve.degrees)});
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
