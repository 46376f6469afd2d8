// What the study knows of its own reliability.
#include "studies/effects/effect_cost.h"

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

results::EffectStudyRecord study_record(const EffectCosts& list) {
  results::EffectStudyRecord out;
  out.started = list.started;
  out.orbs_version = list.orbs_version;
  out.cpu = list.host.cpu;
  out.cores = list.host.cores;
  out.rounds = list.settings.rounds;
  out.spp = list.settings.spp;
  out.size_px = list.settings.size_px;
  out.load = list.load;
  out.load_end = list.load_end;
  out.has_intervals = true;
  out.renders = list.other_load.renders;
  out.repeats = list.other_load.repeats;
  out.disturbed = list.other_load.disturbed;
  out.unknown = list.other_load.unknown;
  std::vector<double> ratios;
  int differing = 0;
  for (const auto& scene : list.scenes) {
    if (!scene.again || !scene.again->time_interval) continue;
    const auto& interval = *scene.again->time_interval;
    ratios.push_back(interval.value);
    differing += interval.low > 1 || interval.high < 1 ? 1 : 0;
  }
  if (ratios.empty()) return out;
  out.self_scenes = static_cast<int>(ratios.size());
  out.self_differing = differing;
  // Of a single scene, its own interval; else by the scatter of the scenes.
  const auto& first = list.scenes.front().again;
  const auto mean = ratios.size() > 1 ? paired_interval(ratios) : first ? first->time_interval : std::nullopt;
  if (!mean) return out;
  out.self_ratio = mean->value;
  out.self_low = mean->low;
  out.self_high = mean->high;
  return out;
}

}  // namespace orbs::studies
