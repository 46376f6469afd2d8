// What the study knows of its own reliability.
#include "studies/effects/self_check.h"

#include "studies/effects/paired_interval.h"

#include <cmath>

namespace orbs::studies {

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
