#include "studies/cost/comparisons.h"

#include "studies/cost/points.h"

#include <cmath>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

constexpr double kSelfOutside =
    0.01;  // the share of equal pairs that are called different, for time and error

// A check that could not see a factor of two says nothing.
bool is_known(const Interval& ratio) { return ratio.high < 2 * ratio.low; }

bool holds_one(const Interval& ratio) { return ratio.low <= 1 && 1 <= ratio.high; }

// Welch's degrees for the difference of two logarithms.
Interval ratio_of(const CostPrice& first, const CostPrice& second) {
  const double a = first.log_error * first.log_error;
  const double b = second.log_error * second.log_error;
  const double squares = a * a / first.degrees + b * b / second.degrees;
  const double degrees = squares > 0 ? (a + b) * (a + b) / squares : 1;
  const auto logs = student_interval(std::log(second.cpu_seconds->value / first.cpu_seconds->value),
                                     std::sqrt(a + b), degrees, kOutside);
  return {std::exp(logs.value), std::exp(logs.low), std::exp(logs.high)};
}

// One reaches the goal and the other does not: whether the bound of the other lies beyond the interval.
bool is_surely_cheaper(const CostPrice& reached, const CostPrice& missed) {
  return missed.at_least && *missed.at_least > reached.cpu_seconds->high;
}

CostComparison compare_prices(const CostPrice& first, const CostPrice& second) {
  CostComparison out;
  out.goal = first.goal;
  out.verdict = "not comparable";
  if (first.cpu_seconds && second.cpu_seconds) {
    out.time_ratio = ratio_of(first, second);
    out.verdict = holds_one(*out.time_ratio)  ? "no difference shown"
                  : out.time_ratio->value > 1 ? "dearer"
                                              : "cheaper";
  } else if (first.cpu_seconds) {
    out.note = second.note;
    if (is_surely_cheaper(first, second)) out.verdict = "dearer";
  } else if (second.cpu_seconds) {
    out.note = first.note;
    if (is_surely_cheaper(second, first)) out.verdict = "cheaper";
  } else {
    out.note = first.note;
  }
  return out;
}

}  // namespace

std::optional<SelfComparison> compare_with_itself(const CostRecord& record) {
  for (std::size_t ladder = 0; ladder < record.ladders.size(); ++ladder) {
    const auto again = renders_of(record, record.ladders[ladder], kAgain);
    if (again.size() < 2) continue;
    const auto first = renders_of(record, record.ladders[ladder], kOfRung, again.front()->rung);
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
    SelfComparison found{ladder, static_cast<int>(again.size()),
                         ratio_interval(times, times_again, kSelfOutside),
                         ratio_interval(errors, errors_again, kSelfOutside)};
    found.is_known = is_known(found.time_ratio) && is_known(found.error_ratio);
    found.passed = found.is_known && holds_one(found.time_ratio) && holds_one(found.error_ratio);
    return found;
  }
  return std::nullopt;
}

std::vector<CostComparison> compare_renderers(const CostRecord& record,
                                              const std::vector<CostCurve>& curves) {
  std::vector<CostComparison> all;
  for (std::size_t i = 0; i < curves.size(); ++i)
    for (std::size_t j = 0; j < curves.size(); ++j) {
      const auto& one = record.ladders[curves[i].ladder];
      const auto& other = record.ladders[curves[j].ladder];
      if (one.target != other.target || one.renderer >= other.renderer) continue;
      for (std::size_t goal = 0; goal < cost_goals().size(); ++goal) {
        auto found = compare_prices(curves[i].prices.at(goal), curves[j].prices.at(goal));
        found.target = one.target;
        found.first = one.renderer;
        found.second = other.renderer;
        all.push_back(std::move(found));
      }
    }
  return all;
}

}  // namespace orbs::studies
