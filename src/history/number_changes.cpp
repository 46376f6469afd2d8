#include "history/number_changes.h"

#include "base/statistics.h"
#include "metrics/noise_test.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>

#include <fmt/format.h>

namespace orbs::history {

namespace {

using results::Measure;
using results::TargetRecord;

// How often intervals of records miss, see mean_ratio.h and noise_numbers.h.
constexpr double kOutsideBias = metrics::kFalseAlarms / metrics::kTests;
constexpr double kOutsideLight = kOutsideBias / 3;

constexpr std::array kChannels{'r', 'g', 'b'};

char upper(char channel) { return static_cast<char>(channel - 'a' + 'A'); }

const Measure* measure_of(const TargetRecord& target, const std::string& name) {
  for (const auto& measure : target.measures)
    if (measure.name == name && std::isfinite(measure.value)) return &measure;
  return nullptr;
}

// The z that a normally distributed number is beyond with this probability.
double normal_quantile(double probability) {
  constexpr double kDegrees = 1e9;
  return student_quantile(probability, kDegrees);
}

double normal_tail(double z) { return std::erfc(std::fabs(z) / std::numbers::sqrt2); }

// `reach`: standard errors from the middle of the interval to its ends.
std::optional<double> error_by_interval(const Measure& measure, double reach) {
  if (!measure.low || !measure.high) return std::nullopt;
  return (*measure.high - *measure.low) / 2 / reach;
}

// Equal numbers cannot have changed, and of numbers without noise every change is one.
double probability_of(const Estimate& before, const Estimate& after) {
  const double difference = after.value - before.value;
  if (difference == 0) return 1;
  return normal_tail(difference / std::hypot(before.error, after.error));
}

Change change_of(const TargetPair& pair, Quantity quantity) {
  Change change;
  change.quantity = quantity;
  change.renderer = pair.after->renderer;
  change.requirement = pair.after->requirement;
  change.target = pair.after->target;
  return change;
}

bool is_compared(const TargetPair& pair) {
  return pair.not_compared.empty() && has_numbers(*pair.before) && has_numbers(*pair.after);
}

// A scene that several cases judge has the same numbers in each.
std::vector<TargetPair> distinct(const RunPair& pair) {
  std::set<std::pair<std::string, std::string>> seen;
  std::vector<TargetPair> targets;
  for (const auto& one : pair.targets)
    if (is_compared(one) && seen.emplace(one.after->renderer, one.after->target).second)
      targets.push_back(one);
  return targets;
}

// Means weighted by the inverse of their variances, which is the combination with the least error.
struct Pooled {
  double weights = 0;
  double before = 0;
  double after = 0;
  int count = 0;
};

void pool(const Estimate& before, const Estimate& after, Pooled& pooled) {
  const double variance = before.error * before.error + after.error * after.error;
  if (!(variance > 0)) return;
  pooled.weights += 1 / variance;
  pooled.before += before.value / variance;
  pooled.after += after.value / variance;
  ++pooled.count;
}

Candidate pooled_candidate(const std::string& renderer, char channel, const Pooled& pooled) {
  Candidate candidate;
  candidate.change.renderer = renderer;
  const double before = pooled.before / pooled.weights;
  const double after = pooled.after / pooled.weights;
  describe_light(upper(channel), before, after, candidate.change);
  if (std::fabs(after - before) > kLeastLight)
    candidate.probability = normal_tail((after - before) * std::sqrt(pooled.weights));
  return candidate;
}

}  // namespace

std::optional<Estimate> mean_light(const TargetRecord& target, char channel) {
  static const double kReach = normal_quantile(kOutsideLight);
  const auto* measure = measure_of(target, fmt::format("mean_ratio_{}", channel));
  if (measure == nullptr) return std::nullopt;
  const auto error = error_by_interval(*measure, kReach);
  if (!error) return std::nullopt;
  return Estimate{measure->value, *error};
}

std::optional<Estimate> mean_squared_error(const TargetRecord& target) {
  static const double kReach = normal_quantile(kOutsideBias);
  const auto* mse = measure_of(target, "mse");
  const auto* bias = measure_of(target, "bias_squared");
  if (mse == nullptr || bias == nullptr) return std::nullopt;
  const auto error = error_by_interval(*bias, kReach);
  if (!error) return std::nullopt;
  return Estimate{mse->value, *error};
}

std::vector<Candidate> light_candidates(const RunPair& pair) {
  std::vector<Candidate> candidates;
  std::map<std::pair<std::string, char>, Pooled> renderers;
  for (const auto& one : distinct(pair))
    for (const char channel : kChannels) {
      const auto before = mean_light(*one.before, channel);
      const auto after = mean_light(*one.after, channel);
      if (!before || !after) continue;
      if (one.after->jobs.size() == 1) pool(*before, *after, renderers[{one.after->renderer, channel}]);
      Candidate candidate{change_of(one, Quantity::Light)};
      describe_light(upper(channel), before->value, after->value, candidate.change);
      if (candidate.change.size > kLeastLight) candidate.probability = probability_of(*before, *after);
      candidates.push_back(std::move(candidate));
    }
  for (const auto& [key, pooled] : renderers)
    if (pooled.count > 1) candidates.push_back(pooled_candidate(key.first, key.second, pooled));
  return candidates;
}

std::vector<Candidate> error_candidates(const RunPair& pair) {
  std::vector<Candidate> candidates;
  for (const auto& one : distinct(pair)) {
    if (one.has_other_samples) continue;
    const auto before = mean_squared_error(*one.before);
    const auto after = mean_squared_error(*one.after);
    if (!before || !after) continue;
    Candidate candidate{change_of(one, Quantity::Error)};
    auto& change = candidate.change;
    change.direction = after->value > before->value ? Direction::Worse : Direction::Better;
    change.before = fmt::format("mse {:.4g}", before->value);
    change.after = fmt::format("{:.4g}", after->value);
    change.size = std::fabs(std::log(after->value / before->value));
    if (change.size > std::log1p(kLeastError)) candidate.probability = probability_of(*before, *after);
    candidates.push_back(std::move(candidate));
  }
  return candidates;
}

}  // namespace orbs::history
