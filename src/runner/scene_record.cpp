#include "runner/scene_record.h"

#include "scene/effects.h"

namespace orbs::runner {

namespace {

std::vector<results::EffectRecord> records_of(const std::vector<scene::EffectFinding>& findings) {
  std::vector<results::EffectRecord> records;
  for (const auto& [effect, object, reason] : findings)
    records.push_back({std::string(scene::effect_name(effect)), object, reason});
  return records;
}

}  // namespace

results::SceneRecord scene_record(const std::string& name, const scene::Scene& scene) {
  const auto found = scene::effects(scene);
  return {name, std::string(scene::transport_name(scene::transport(found))), records_of(found.called_for),
          records_of(found.not_called_for)};
}

}  // namespace orbs::runner
