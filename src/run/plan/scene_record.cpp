#include "run/plan/scene_record.h"

#include "registry/features.h"
#include "scene/effects/effects.h"
#include "scene/effects/features.h"

namespace orbs::run {

namespace {

std::vector<results::EffectRecord> records_of(const std::vector<scene::EffectFinding>& findings) {
  std::vector<results::EffectRecord> records;
  for (const auto& [effect, object, reason] : findings)
    records.push_back({std::string(scene::effect_name(effect)), object, reason});
  return records;
}

// In ORB.S notation, which has levels for renderers and scene files alike.
std::string feature_number(const scene::Scene& scene) {
  registry::FeatureSet features;
  for (const auto& called : scene::features_called_for(scene)) {
    const auto code = registry::parse_requirement(called.requirement);
    features[code.group].insert(code.level);
  }
  return registry::format_features(features);
}

}  // namespace

results::SceneRecord scene_record(const std::string& name, const scene::Scene& scene) {
  const auto found = scene::effects(scene);
  return {name, std::string(scene::transport_name(scene::transport(found))), records_of(found.called_for),
          records_of(found.not_called_for), feature_number(scene)};
}

}  // namespace orbs::run
