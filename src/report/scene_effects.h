#pragma once

#include "json/fields.h"
#include "results/record.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace orbs::report {

/// What a scene calls for, and the cost of each effect; the reasons are in the data of the target.
struct SceneEffects {
  std::string name;
  std::string transport;
  std::optional<std::size_t> cell;  // the first target that shows this scene alone
  std::vector<std::string> called_for, not_called_for;
  std::vector<results::EffectCostRecord> costs;
};

template <class Visitor, json::RecordOf<SceneEffects> Record>
void fields(Visitor& visit, Record& scene) {
  visit("name", scene.name);
  visit("transport", scene.transport);
  visit("cell", scene.cell);
  visit("called_for", scene.called_for);
  visit("not_called_for", scene.not_called_for);
  visit("costs", scene.costs);
}

/// The scenes of a run with the effects that each calls for, once each.
std::vector<SceneEffects> scene_effects(const results::RunRecord& run);

}  // namespace orbs::report
