#include "report/scene_effects.h"

#include <algorithm>

namespace orbs::report {

namespace {

// The findings of one effect are adjacent.
std::vector<std::string> names_of(const std::vector<results::EffectRecord>& effects) {
  std::vector<std::string> names;
  for (const auto& one : effects)
    if (std::find(names.begin(), names.end(), one.effect) == names.end()) names.push_back(one.effect);
  return names;
}

}  // namespace

std::vector<SceneEffects> scene_effects(const results::RunRecord& run) {
  const auto jobs = results::jobs_by_id(run);
  std::map<std::string, std::size_t> cells;
  for (std::size_t i = 0; i < run.targets.size(); ++i) {
    const auto& target = run.targets[i];
    if (target.jobs.size() != 1) continue;
    if (const auto job = jobs.find(target.jobs.front()); job != jobs.end())
      cells.try_emplace(job->second->identity.scene, i);
  }
  std::vector<SceneEffects> scenes;
  for (const auto& scene : run.scenes) {
    const auto cell = cells.find(scene.name);
    scenes.push_back({scene.name, scene.transport,
                      cell == cells.end() ? std::nullopt : std::optional(cell->second),
                      names_of(scene.called_for), names_of(scene.not_called_for), scene.effect_costs});
  }
  return scenes;
}

}  // namespace orbs::report
