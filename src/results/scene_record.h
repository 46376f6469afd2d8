#pragma once

#include "json/fields.h"

#include <optional>
#include <string>
#include <vector>

/// What is recorded of a case and of its scenes. Each member is also listed in the struct's fields(): see
/// fields.h.
namespace orbs::results {

/// What a case is about, in the words of its case.json.
struct CaseRecord {
  std::string suite;
  std::string name;
  std::string requirement;
  std::string title;
  std::string tests;
  std::string typical_mistake;
  std::string smallest_error_seen = {};  // by its gate, in words; "" if nobody has tried
};

template <class Visitor, json::RecordOf<CaseRecord> Record>
void fields(Visitor& visit, Record& one_case) {
  visit("suite", one_case.suite);
  visit.required("name", one_case.name);
  visit("requirement", one_case.requirement);
  visit("title", one_case.title);
  visit("tests", one_case.tests);
  visit("typical_mistake", one_case.typical_mistake);
  visit("smallest_error_seen", one_case.smallest_error_seen);
}

/// An effect of light, and the part of the scene that calls for it or looks as if it did, with the reason.
struct EffectRecord {
  std::string effect;   // "thin film"
  std::string subject;  // "material 'copper'"
  std::string reason;   // follows the subject: "has a film 550 nm high"
};

template <class Visitor, json::RecordOf<EffectRecord> Record>
void fields(Visitor& visit, Record& effect) {
  visit.required("effect", effect.effect);
  visit("subject", effect.subject);
  visit("reason", effect.reason);
}

/// A scene rendered with more or fewer effects than it calls for: the cost, and what changes in the image.
struct EffectCostRecord {
  std::string name;        // "polarised", "without dispersion"
  double time_ratio = 0;   // CPU time per sample over that of the effects that the scene calls for
  double error_ratio = 0;  // the same for CPU time to equal noise; 0 if unknown
  std::string change;      // "same to the bit", or how the image differs
  std::optional<double> time_low = {}, time_high = {};             // around time_ratio; see EffectStudyRecord
  std::optional<double> mean_change = {}, mean_change_error = {};  // relative to the image that is called for
  bool is_enough = false;                                          // carries all that the scene calls for
  bool is_equal = false;                                           // the same image to the bit
  bool is_comparable = true;  // false: one of both traces light paths, so its times are of other work
};

template <class Visitor, json::RecordOf<EffectCostRecord> Record>
void fields(Visitor& visit, Record& cost) {
  visit.required("name", cost.name);
  visit.required("time_ratio", cost.time_ratio);
  visit.required("error_ratio", cost.error_ratio);
  visit("change", cost.change);
  visit("time_low", cost.time_low);
  visit("time_high", cost.time_high);
  visit("mean_change", cost.mean_change);
  visit("mean_change_error", cost.mean_change_error);
  visit("is_enough", cost.is_enough);
  visit("is_equal", cost.is_equal);
  visit("is_comparable", cost.is_comparable);
}

/// How and when the effect costs were measured: on which machine, what else it did, and whether a scene that
/// was rendered twice in the same way differs from itself.
struct EffectStudyRecord {
  std::string started;
  std::string orbs_version;
  std::string cpu;
  int cores = 0;
  int rounds = 0;
  int spp = 0;
  int size_px = 0;
  double load = 0;                 // when it started
  std::optional<double> load_end;  // when it ended
  bool has_intervals = false;  // time_low to time_high holds 95 %; else smallest and largest of the rounds
  std::optional<int> renders, repeats, disturbed, unknown;  // by what others took; see OtherLoad
  /// Scenes that were compared with themselves, and those where that showed a difference; absent: none was.
  std::optional<int> self_scenes, self_differing;
  std::optional<double> self_ratio, self_low, self_high;  // geometric mean of their time ratios, 95 %
};

template <class Visitor, json::RecordOf<EffectStudyRecord> Record>
void fields(Visitor& visit, Record& study) {
  visit("started", study.started);
  visit("orbs_version", study.orbs_version);
  visit("cpu", study.cpu);
  visit("cores", study.cores);
  visit("rounds", study.rounds);
  visit("spp", study.spp);
  visit("size_px", study.size_px);
  visit("load", study.load);
  visit("load_end", study.load_end);
  visit("has_intervals", study.has_intervals);
  visit("renders", study.renders);
  visit("repeats", study.repeats);
  visit("disturbed", study.disturbed);
  visit("unknown", study.unknown);
  visit("self_scenes", study.self_scenes);
  visit("self_differing", study.self_differing);
  visit("self_ratio", study.self_ratio);
  visit("self_low", study.self_low);
  visit("self_high", study.self_high);
}

/// What a scene calls for, and what its light paths must carry for that.
struct SceneRecord {
  std::string name;
  std::string transport;  // "rgb", "spectral", "polarised", "bispectral", "polarised-bispectral"
  std::vector<EffectRecord> called_for;
  std::vector<EffectRecord> not_called_for;
  std::string features = {};  // feature number: the requirements that it calls for, in ORB.S notation
  std::vector<EffectCostRecord> effect_costs = {};  // from orbs effect-cost; empty if nobody has measured
  std::vector<EffectRecord> switches = {};  // what a renderer can switch, "mirrors", and what calls for it
  int bounces = 0;                          // that can matter; 0 where nothing reflects
  std::string size = {};  // "1/2": of its image, where that is not the run's; see registry::divisor_of_image
};

template <class Visitor, json::RecordOf<SceneRecord> Record>
void fields(Visitor& visit, Record& scene) {
  visit.required("name", scene.name);
  visit("transport", scene.transport);
  visit("features", scene.features);
  visit("called_for", scene.called_for);
  visit("not_called_for", scene.not_called_for);
  visit("effect_costs", scene.effect_costs);
  visit("switches", scene.switches);
  visit("bounces", scene.bounces);
  visit("size", scene.size);
}

}  // namespace orbs::results
