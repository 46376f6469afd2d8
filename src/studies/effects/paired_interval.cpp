#include "studies/effects/paired_interval.h"

#include "studies/seed_statistics.h"

#include <cmath>

namespace orbs::studies {

namespace {

std::optional<LogRatio> paired_log(const std::vector<double>& ratios) {
  std::vector<double> logs;
  for (const double ratio : ratios) {
    if (!(ratio > 0) || !std::isfinite(ratio)) return std::nullopt;
    logs.push_back(std::log(ratio));
  }
  // A single round says nothing of its scatter.
  if (logs.size() < 2) return std::nullopt;
  const auto sample = sample_of(logs);
  return LogRatio{sample.mean, sample.variance / sample.count, static_cast<double>(sample.count - 1)};
}

}  // namespace

std::optional<Interval> paired_interval(const std::vector<double>& ratios) {
  const auto log = paired_log(ratios);
  if (!log) return std::nullopt;
  return ratio_interval(*log);
}

}  // namespace orbs::studies
