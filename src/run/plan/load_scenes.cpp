#include "run/plan/load_scenes.h"

#include "base/error.h"
#include "base/files.h"
#include "registry/features.h"
#include "scene/effects/effects.h"
#include "scene/effects/features.h"
#include "scene/load/load_scene.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

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

std::uint64_t scene_content_hash(const scene::Scene& scene, const std::filesystem::path& file) {
  auto hash = content_hash(read_file(file));
  if (!scene.notes.camera.empty()) hash = content_hash(scene.notes.camera, hash);
  const auto add = [&](const auto& values) {
    hash =
        content_hash({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0])}, hash);
  };
  for (const auto& mesh : scene.meshes) {
    add(mesh.positions);
    add(mesh.normals);
    add(mesh.tangents);
    add(mesh.uvs);
    add(mesh.triangles);
    add(mesh.triangle_materials);
  }
  for (const auto& texture : scene.textures) hash = content_hash(read_file(texture.file), hash);
  for (const auto& light : scene.lights)
    if (light.ies) hash = content_hash(read_file(light.ies->file), hash);
  for (const auto& table : scene.notes.tables) hash = content_hash(read_file(table), hash);
  return hash;
}

namespace {

const PlannedScene* planned_scene(const Plan& plan, const std::string& name) {
  const auto found = std::find_if(plan.scenes.begin(), plan.scenes.end(),
                                  [&](const auto& scene) { return scene.name == name; });
  return found == plan.scenes.end() ? nullptr : &*found;
}

std::shared_ptr<const scene::Scene> loaded(const registry::CaseScene& wanted, const registry::Suite& suite) {
  return with_note(fmt::format("reading scene '{}'", wanted.name), [&] {
    return std::make_shared<const scene::Scene>(scene::load_scene(wanted.file, suite.data, wanted.camera));
  });
}

}  // namespace

void load_scenes(Plan& plan) {
  using FileAndCamera = std::pair<std::string, std::string>;
  std::map<FileAndCamera, std::size_t> first;  // scene that is made of them
  for (const auto& one_case : plan.cases)
    for (const auto& wanted : one_case.scenes) {
      if (planned_scene(plan, wanted.name) != nullptr) continue;
      PlannedScene planned{wanted.name, wanted.file,         wanted.spp,          nullptr,
                           "",          wanted.camera_paths, wanted.wall_seconds, wanted.arguments};
      const auto [same, is_new] =
          first.try_emplace({wanted.file.string(), wanted.camera}, plan.scenes.size());
      if (is_new) {
        planned.scene = with_note(fmt::format("reading {}", one_case.file.string()),
                                  [&] { return loaded(wanted, plan.suite); });
        planned.hash = scene_content_hash(*planned.scene, planned.file);
      } else {
        planned.scene = plan.scenes[same->second].scene;
        planned.hash = plan.scenes[same->second].hash;
      }
      plan.scenes.push_back(std::move(planned));
    }
}

void hash_references(const std::vector<registry::Case>& all, Plan& plan) {
  std::map<std::string, std::string> others;  // scenes that are not in the plan
  const auto hash_of = [&](const std::string& reference) -> std::string {
    if (const auto* planned = planned_scene(plan, reference)) return hash_text(planned->hash);
    for (const auto& one_case : all)
      for (const auto& scene : one_case.scenes) {
        if (scene.name != reference) continue;
        const auto [hash, is_new] = others.try_emplace(reference);
        if (is_new) hash->second = hash_text(scene_content_hash(*loaded(scene, plan.suite), scene.file));
        return hash->second;
      }
    return "";  // it has none: load_cases has seen to it that there is one wherever one must be
  };
  std::set<std::string> known;
  for (const auto& one_case : plan.cases)
    for (const auto& scene : one_case.scenes) {
      if (!known.insert(scene.name).second) continue;
      plan.reference_hashes[scene.name] = hash_of(registry::reference_name(scene));
      for (const auto& accepted : scene.accepted)
        plan.reference_hashes[accepted.reference] = hash_of(accepted.reference);
    }
}

}  // namespace orbs::run
