#pragma once

#include "json/fields.h"

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
};

template <class Visitor, json::RecordOf<EffectCostRecord> Record>
void fields(Visitor& visit, Record& cost) {
  visit.required("name", cost.name);
  visit.required("time_ratio", cost.time_ratio);
  visit.required("error_ratio", cost.error_ratio);
  visit("change", cost.change);
}

/// What a scene calls for, and what its light paths must carry for that.
struct SceneRecord {
  std::string name;
  std::string transport;  // "rgb", "spectral", "polarised", "bispectral", "polarised-bispectral"
  std::vector<EffectRecord> called_for;
  std::vector<EffectRecord> not_called_for;
  std::string features = {};  // feature number: the requirements that it calls for, in ORB.S notation
  std::vector<EffectCostRecord> effect_costs = {};  // from orbs effect-cost; empty if nobody has measured
};

template <class Visitor, json::RecordOf<SceneRecord> Record>
void fields(Visitor& visit, Record& scene) {
  visit.required("name", scene.name);
  visit("transport", scene.transport);
  visit("features", scene.features);
  visit("called_for", scene.called_for);
  visit("not_called_for", scene.not_called_for);
  visit("effect_costs", scene.effect_costs);
}

}  // namespace orbs::results
