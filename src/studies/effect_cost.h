#pragma once

#include "registry/configuration.h"
#include "results/record.h"
#include "studies/spread.h"

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// What generality costs and what effects are worth: each scene with the transport that it calls for, with
/// the others, and without single effects, all with the same random numbers.
namespace orbs::studies {

struct EffectCostSettings {
  int rounds = 4;     // each with its own seed; at least 2
  int spp = 16;       // of each render
  int size_px = 128;  // the longer side
};

struct EffectCostContext {
  std::filesystem::path build;  // {build}
  std::string orbs_version;
  const std::atomic<bool>* stop = nullptr;
  std::function<void(const std::string&)> say;
};

/// A number from several rounds.
struct MeanOfRounds {
  double value = 0;
  double standard_error = 0;
};

/// How an image differs from that of what the scene calls for, in Rec.709 luminance over the mean of that
/// image.
struct ImageChange {
  bool is_equal = false;  // to the bit, in all rounds
  MeanOfRounds mean;
  MeanOfRounds largest;  // of the blocks of 8 x 8 px
  int x = 0;             // the block's upper left pixel
  int y = 0;
  std::string bias;  // more than noise, in words; "" when it is not
  /// One of the two has light paths and the other cannot: what caustics it has are too rare to compare.
  bool is_comparable = true;
};

/// The scene rendered otherwise than it calls for.
struct Alternative {
  std::string name;        // "spectral", "without dispersion"
  bool is_enough = false;  // has all that the scene calls for: a bias is an error
  Spread time_ratio;       // CPU time per sample over that of what the scene calls for, round by round
  /// CPU time to the same noise, likewise: that times the ratio of variances. 0 where nobody knows.
  double error_ratio = 0;
  ImageChange change;
};

struct SceneEffectCosts {
  std::string scene;
  std::string transport;  // that the scene calls for
  std::vector<std::string> effects;
  double paths_per_cpu_second = 0;  // median
  std::vector<Alternative> alternatives;
};

struct EffectCosts {
  EffectCostSettings settings;
  std::string orbs_version;
  std::string suite;
  std::string started;  // local time, ISO 8601
  results::Host host;
  double load = 0;  // when it started
  std::vector<SceneEffectCosts> scenes;
};

/// Nothing when stopped. `scenes`: patterns of names in the suite. InputError when a render fails.
std::optional<EffectCosts> measure_effect_costs(const registry::Configuration& configuration,
                                                const std::string& suite,
                                                const std::string& scenes,
                                                const EffectCostSettings& settings,
                                                const EffectCostContext& context);

/// Whether every richer transport gave the same image.
bool all_agree(const EffectCosts& list);

/// For people: a line for each alternative.
std::string effect_cost_table(const EffectCosts& list);
/// The same as a table in Markdown.
std::string effect_cost_markdown(const EffectCosts& list);
/// All numbers, format "orbs-effect-cost/1".
std::string effect_cost_json(const EffectCosts& list);

}  // namespace orbs::studies
