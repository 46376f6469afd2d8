#pragma once

#include "registry/configuration.h"
#include "results/record.h"
#include "studies/context.h"
#include "studies/effects/image_change.h"
#include "studies/seed_statistics.h"

#include <optional>
#include <string>
#include <vector>

/// The cost of effects: each scene is rendered with the transport that it calls for, with all other
/// transports and without single effects, always with the same random numbers.
namespace orbs::studies {

struct EffectCostSettings {
  int rounds = 4;     // at least 2; each has its own seed
  int spp = 16;       // samples per pixel of each render
  int size_px = 128;  // longer side of the images
};

/// The scene rendered with another transport, or without one of its effects.
struct Alternative {
  std::string name;        // "spectral", "without dispersion"
  bool is_enough = false;  // carries all that the scene calls for, so a bias is an error
  Spread time_ratio;       // CPU time per sample over that of the usual transport, round by round
  /// The ratio of CPU times to equal noise: time_ratio times the ratio of variances. 0 if unknown.
  double error_ratio = 0;
  ImageChange change;
  /// 95 % around the geometric mean of time_ratio, from its scatter over the rounds; nothing if a time is 0.
  std::optional<Interval> time_interval = {};
};

struct SceneEffectCosts {
  std::string scene;
  std::string transport;  // the one that the scene calls for
  std::vector<std::string> effects;
  double paths_per_cpu_second = 0;  // median
  std::vector<Alternative> alternatives;
  /// The scene itself, rendered once more in each round (A/A): any difference is that of the machine.
  std::optional<Alternative> again = {};
};

/// What other work did to the renders of the study, by the rule of the cost study: see other_load.h. A render
/// that stays disturbed is kept, since each round is a pair, and counted.
struct EffectCostLoad {
  int renders = 0;
  int repeats = 0;
  int disturbed = 0;
  int unknown = 0;  // renders of which it is not known
};

struct EffectCosts {
  EffectCostSettings settings;
  std::string orbs_version;
  std::string suite;
  std::string started;  // local time, ISO 8601
  results::Host host;
  double load = 0;  // when the study started
  std::vector<SceneEffectCosts> scenes;
  double load_end = 0;
  EffectCostLoad other_load = {};
};

/// Measures the scenes of the suite whose names match `scenes`, comma-separated patterns. None if the user
/// interrupts. InputError if a render fails.
std::optional<EffectCosts> measure_effect_costs(const registry::Configuration& configuration,
                                                const std::string& suite,
                                                const std::string& scenes,
                                                const EffectCostSettings& settings,
                                                const StudyContext& context);

/// True if every richer transport gave the same image.
bool all_agree(const EffectCosts& list);

}  // namespace orbs::studies
