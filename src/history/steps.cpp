#include "history/steps.h"

#include "base/statistics.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/format.h>

namespace orbs::history {

namespace {

double mean_of(const std::vector<double>& numbers, std::size_t begin, std::size_t end) {
  double sum = 0;
  for (std::size_t i = begin; i < end; ++i) sum += numbers[i];
  return sum / static_cast<double>(end - begin);
}

}  // namespace

Split best_split(const Values& values) {
  const auto& x = values.numbers;
  const auto count = static_cast<double>(x.size());
  const double degrees = count - 2;
  Split best;
  double best_t = -1;
  for (std::size_t at = 1; at < x.size(); ++at) {
    const double before = mean_of(x, 0, at);
    const double after = mean_of(x, at, x.size());
    double squares = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double residual = x[i] - (i < at ? before : after);
      squares += residual * residual;
    }
    const auto first = static_cast<double>(at);
    const double error = std::sqrt(squares / degrees * (1 / first + 1 / (count - first)));
    const double t = before == after ? 0 : std::fabs(after - before) / error;
    if (t > best_t) {
      best = {at, before, after, 1};
      best_t = t;
    }
  }
  best.probability =
      std::min(1.0, student_tail(best_t, std::min(degrees, values.most_degrees)) * (count - 1));
  return best;
}

namespace {

std::string stamp_text(const RunStamp& run) { return fmt::format("{} ({})", run.name, run.started); }

// The candidate of a step in `values`, if they are enough. `describe` fills the change from the two means and
// says whether the step is large enough.
template <typename Describe>
void add_candidate(const Values& values,
                   const History& history,
                   Change change,
                   Describe&& describe,
                   std::vector<Candidate>& candidates) {
  if (values.numbers.size() < kFewestRuns) return;
  const auto split = best_split(values);
  const bool is_large = describe(split.before, split.after, change);
  change.since = stamp_text(history.runs[values.runs[split.at]]);
  candidates.push_back({std::move(change), is_large ? split.probability : 1});
}

bool is_large_light(char channel, double before, double after, Change& change) {
  describe_light(channel, before, after, change);
  return change.size > kLeastLight;
}

// Of logarithms, whose differences are ratios.
bool describe_ratio(Quantity quantity, double before, double after, Change& change) {
  change.quantity = quantity;
  change.direction = after > before ? Direction::Worse : Direction::Better;
  const char* unit = quantity == Quantity::Time ? " s" : "";
  change.before =
      fmt::format("{}{:.4g}{}", quantity == Quantity::Error ? "mse " : "", std::exp(before), unit);
  change.after = fmt::format("{:.4g}{} ({:+.1f} %)", std::exp(after), unit, 100 * std::expm1(after - before));
  change.size = std::fabs(after - before);
  return change.size > std::log1p(quantity == Quantity::Time ? kLeastTime : kLeastError);
}

Values times_of(const Series& series) {
  constexpr double kMostDegrees = 8;  // times have outliers
  Values values{{}, {}, kMostDegrees};
  for (const auto& point : series.points)
    if (point.cpu_seconds) {
      values.runs.push_back(point.run);
      values.numbers.push_back(std::log(*point.cpu_seconds));
    }
  return values;
}

Values errors_of(const Series& series) {
  Values values;
  for (const auto& point : series.points)
    if (point.mse && *point.mse > 0) {
      values.runs.push_back(point.run);
      values.numbers.push_back(std::log(*point.mse));
    }
  return values;
}

Values light_of(const Series& series, std::size_t channel) {
  Values values;
  for (const auto& point : series.points)
    if (const auto& light = point.light.at(channel)) {
      values.runs.push_back(point.run);
      values.numbers.push_back(light->value);
    }
  return values;
}

/// A number of a renderer as a whole: weighted means over those of its targets that every run has.
struct Sums {
  std::vector<double> sums;  // by run
  double weights = 0;
};

// `value`: of a point, with its weight. A series that lacks a run is left out, since a mean over other
// targets is another number.
template <typename Value>
Values whole_renderer(const History& history, const std::vector<const Series*>& series, Value&& value) {
  Sums total{std::vector<double>(history.runs.size(), 0), 0};
  for (const auto* one : series) {
    if (one->points.size() != history.runs.size()) continue;
    double weight = 0;
    std::vector<double> numbers;
    for (const auto& point : one->points)
      if (const auto found = value(point)) {
        numbers.push_back(found->first);
        weight += found->second;
      }
    if (numbers.size() != history.runs.size()) continue;
    for (std::size_t i = 0; i < numbers.size(); ++i) total.sums[i] += weight * numbers[i];
    total.weights += weight;
  }
  Values values;
  if (!(total.weights > 0)) return values;
  for (std::size_t i = 0; i < total.sums.size(); ++i) {
    values.runs.push_back(i);
    values.numbers.push_back(total.sums[i] / total.weights);
  }
  return values;
}

using Weighted = std::optional<std::pair<double, double>>;

Weighted weighted_time(const Point& point) {
  if (!point.cpu_seconds) return std::nullopt;
  return std::pair(std::log(*point.cpu_seconds), 1.0);
}

Weighted weighted_light(const Point& point, std::size_t channel) {
  const auto& light = point.light.at(channel);
  if (!light || !(light->error > 0)) return std::nullopt;
  return std::pair(light->value, 1 / (light->error * light->error));
}

struct Candidates {
  std::vector<Candidate> light, error, time;
};

void add_renderers(const History& history,
                   const std::map<std::string, std::vector<const Series*>>& renderers,
                   Candidates& candidates) {
  for (const auto& [name, series] : renderers) {
    Change change;
    change.renderer = name;
    // The geometric mean of the times of its targets.
    add_candidate(
        whole_renderer(history, series, weighted_time), history, change,
        [](double a, double b, Change& c) { return describe_ratio(Quantity::Time, a, b, c); },
        candidates.time);
    for (std::size_t channel = 0; channel < 3; ++channel)
      add_candidate(
          whole_renderer(history, series, [&](const Point& p) { return weighted_light(p, channel); }),
          history, change,
          [&](double a, double b, Change& c) { return is_large_light("RGB"[channel], a, b, c); },
          candidates.light);
  }
}

void add_target(const History& history, const Series& series, Candidates& candidates) {
  Change change;
  change.renderer = series.renderer;
  change.requirement = series.requirement;
  change.target = series.target;
  for (std::size_t channel = 0; channel < 3; ++channel)
    add_candidate(
        light_of(series, channel), history, change,
        [&](double a, double b, Change& c) { return is_large_light("RGB"[channel], a, b, c); },
        candidates.light);
  const auto describe = [](Quantity quantity) {
    return [quantity](double a, double b, Change& c) { return describe_ratio(quantity, a, b, c); };
  };
  add_candidate(errors_of(series), history, change, describe(Quantity::Error), candidates.error);
  add_candidate(times_of(series), history, change, describe(Quantity::Time), candidates.time);
}

}  // namespace

std::vector<Change> find_steps(const History& history) {
  constexpr int kKinds = 3;
  std::map<std::string, std::vector<const Series*>> renderers;
  Candidates candidates;
  std::set<std::pair<std::string, std::string>> seen;  // a scene that several cases judge counts once
  for (const auto& series : history.series) {
    if (!seen.emplace(series.renderer, series.target).second) continue;
    add_target(history, series, candidates);
    if (series.is_one_render) renderers[series.renderer].push_back(&series);
  }
  add_renderers(history, renderers, candidates);
  std::vector<Change> steps;
  for (auto* kind : {&candidates.light, &candidates.error, &candidates.time})
    keep_significant(std::move(*kind), kFalseAlarms / kKinds, steps);
  std::stable_sort(steps.begin(), steps.end(), [](const Change& a, const Change& b) {
    return std::tuple(a.direction, a.quantity, -a.size) < std::tuple(b.direction, b.quantity, -b.size);
  });
  return steps;
}

}  // namespace orbs::history
