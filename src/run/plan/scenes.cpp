#include "run/plan/scenes.h"

#include "adapters/native_scene.h"
#include "base/error.h"
#include "base/files.h"
#include "judge/judge.h"
#include "metrics/mask.h"
#include "registry/features.h"
#include "registry/image_size.h"
#include "registry/placeholders.h"
#include "scene/effects/effects.h"
#include "scene/effects/features.h"
#include "scene/effects/switches.h"
#include "scene/load/load_scene.h"

#include <algorithm>
#include <map>
#include <memory>
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
  results::SceneRecord record{name, std::string(scene::transport_name(scene::transport(found))),
                              records_of(found.called_for), records_of(found.not_called_for),
                              feature_number(scene)};
  for (const auto& one : scene::light_switches(scene)) record.switches.push_back({one.word, one.what, ""});
  record.bounces = scene::bounces_that_matter(scene);
  return record;
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
    add(mesh.second_uvs);
    add(mesh.triangles);
    add(mesh.triangle_materials);
    if (!mesh.end) continue;
    add(mesh.end->positions);
    add(mesh.end->normals);
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

const PlannedScene* scene_of_target(const Plan& plan,
                                    const registry::Case& one_case,
                                    const std::string& target) {
  for (const auto& difference : one_case.differences)
    if (difference.name == target) return planned_scene(plan, difference.of);
  return planned_scene(plan, target);
}

void load_scenes(Plan& plan) {
  using FileAndCamera = std::pair<std::string, std::string>;
  std::map<FileAndCamera, std::size_t> first;  // scene that is made of them
  for (const auto& one_case : plan.cases)
    for (const auto& wanted : one_case.scenes) {
      if (planned_scene(plan, wanted.name) != nullptr) continue;
      PlannedScene planned{wanted.name, wanted.file,         wanted.spp,          nullptr,
                           1,           wanted.camera_paths, wanted.wall_seconds, wanted.arguments};
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

namespace {

void reduce_camera(PlannedScene& planned, const registry::RunSettings& settings) {
  // The same field of view: it is given by fov_y and the ratio of width and height.
  auto reduced = *planned.scene;
  planned.size_divisor = registry::divisor_of_image(reduced.camera.width_px, reduced.camera.height_px,
                                                    registry::reduced_size(settings));
  reduced.camera.width_px /= planned.size_divisor;
  reduced.camera.height_px /= planned.size_divisor;
  planned.scene = std::make_shared<const scene::Scene>(std::move(reduced));
}

std::string mask_problem(const registry::Case& one_case,
                         const std::string& target,
                         const scene::Camera& camera) {
  try {
    metrics::included_pixels(judge::mask_of(one_case, target), camera.width_px, camera.height_px);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

void reduce_size(Plan& plan) {
  if (plan.settings.size_divisor == 1) return;
  for (auto& scene : plan.scenes) reduce_camera(scene, plan.settings);
  for (auto& one_case : plan.cases) {
    const auto full = one_case;
    one_case = registry::reduced_case(full, [&](const std::string& target) {
      const auto* scene = scene_of_target(plan, full, target);
      return scene == nullptr ? 1 : scene->size_divisor;
    });
  }
}

int enough_spp(const PlannedScene& scene, const registry::Renderer& renderer) {
  if (scene.size_divisor == 1 || renderer.sampling.is_noise_free) return scene.spp;
  const int pixels = scene.scene->camera.width_px * scene.scene->camera.height_px;
  return std::max(scene.spp, (scene.camera_paths + pixels - 1) / pixels);
}

std::string why_not_at_size(const Plan& plan,
                            const registry::Renderer& renderer,
                            const registry::Case& one_case,
                            const std::string& target,
                            const std::vector<std::string>& scenes) {
  const int divisor = planned_scene(plan, scenes.front())->size_divisor;
  if (divisor == 1) return "";
  const auto prefix = fmt::format("not measured at {}: ", registry::size_text(divisor));
  if (!renderer.sampling.has_box_filter)
    return fmt::format(
        "{}{} does not filter by a box of one pixel (box_filter), so its image is no average "
        "of the full one",
        prefix, renderer.name);
  const bool command_has_size = registry::uses_placeholder(renderer.command.words, "width") &&
                                registry::uses_placeholder(renderer.command.words, "height");
  for (const auto& name : scenes) {
    const auto* planned = planned_scene(plan, name);
    if (!command_has_size && !adapters::native_scene(renderer, planned->file, name).empty())
      return fmt::format(
          "{}the hand-written scene '{}' sets its own size, as the command does not use "
          "{{width}} and {{height}}",
          prefix, name);
    if (const auto problem = mask_problem(one_case, target, planned->scene->camera); !problem.empty())
      return prefix + problem;
  }
  return "";
}

}  // namespace orbs::run
