#include "scene/lower.h"

#include "scene/called.h"
#include "scene/effects.h"
#include "scene/lower_parts.h"

#include <map>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

bool has_several_materials(const Mesh& mesh) {
  return std::set<int>(mesh.triangle_materials.begin(), mesh.triangle_materials.end()).size() > 1;
}

std::vector<CalledFeature> features_of_geometry(const Scene& scene) {
  std::vector<CalledFeature> features{{"G1", "the scene is made of triangles"},
                                      {"G2", "the scene has a camera"}};
  std::set<int> seen;
  for (const auto& instance : scene.instances) {
    const auto& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
    if (!seen.insert(instance.mesh).second)
      features.push_back({"G3", fmt::format("mesh '{}' appears several times", mesh.name)});
    if (instance.matrix != Mat4{})
      features.push_back({"G3", fmt::format("instance '{}' has a matrix", instance.name)});
    if (!instance.remap.empty())
      features.push_back(
          {has_several_materials(mesh) ? "G5" : "G4",
           fmt::format("instance '{}' changes materials of mesh '{}'", instance.name, mesh.name)});
  }
  for (std::size_t i = 0; i < scene.spheres.size(); ++i)
    features.push_back({"S1", called("shape", scene.spheres[i].name, i) + " is a sphere by its formula"});
  for (std::size_t i = 0; i < scene.meshes.size(); ++i)
    if (!seen.contains(static_cast<int>(i)))
      features.push_back(
          {"G3", fmt::format("mesh '{}' is not instanced and must not appear", scene.meshes[i].name)});
  return features;
}

// The first feature beyond the capabilities, as a reason; "" when there is none.
std::string lacking(const std::vector<CalledFeature>& features, const Capabilities& capabilities) {
  for (const auto& feature : features)
    if (!capabilities.contains(feature.requirement))
      return fmt::format("{}, which needs {}", feature.what, feature.requirement);
  return "";
}

std::string lower_lights(Scene& scene, const Capabilities& capabilities) {
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    auto& light = scene.lights[i];
    if (std::holds_alternative<SphereShape>(light.shape) && !uniform_scale(light.matrix))
      return called("light", light.name, i) +
             " is a sphere with a scale that is not uniform, which no level of ORB.S has";
    if (capabilities.contains("L3")) continue;
    const auto moved = without_matrix(light);
    if (!moved)
      return called("light", light.name, i) +
             " is turned or scaled in a way that its sizes cannot take up, which needs L3";
    light = *moved;
  }
  return lacking(features_of_lights(scene), capabilities);
}

std::string lower_materials(Scene& scene, const Capabilities& capabilities) {
  if (!capabilities.contains("M7")) replace_smooth_oren_nayar(scene);
  if (!capabilities.contains("E1")) replace_plain_dielectrics(scene);
  if (!capabilities.contains("M5")) bake_texture_matrices(scene);
  return lacking(features_of_materials(scene), capabilities);
}

std::string lower_effects(Scene& scene, const Capabilities& capabilities) {
  if (!capabilities.contains("E2") && !calls_for(effects(scene), Effect::Spectral)) drop_spectra(scene);
  return lacking(features_of_effects(scene), capabilities);
}

std::string lower_geometry(Scene& scene, const Capabilities& capabilities) {
  if (!capabilities.contains("S1")) tessellate_spheres(scene);
  if (!capabilities.contains("G1") && !capabilities.contains("G2"))
    return "the scene is made of triangles, which needs G1";
  if (!capabilities.contains("G3")) {
    merge_into_world_mesh(scene);
  } else if (capabilities.contains("G5")) {
    return "";
  } else if (capabilities.contains("G4")) {
    split_by_material(scene);
  } else {
    resolve_remap_lists(scene);
  }
  return "";
}

}  // namespace

std::vector<CalledFeature> features_called_for(const Scene& scene) {
  std::map<std::string, std::string> found;
  for (const auto& features : {features_of_geometry(scene), features_of_materials(scene),
                               features_of_lights(scene), features_of_effects(scene)})
    for (const auto& feature : features) found.try_emplace(feature.requirement, feature.what);
  std::vector<CalledFeature> out;
  for (const auto& [requirement, what] : found) out.push_back({requirement, what});
  return out;
}

std::variant<Scene, std::string> lower(const Scene& scene, const Capabilities& capabilities) {
  Scene lowered = scene;
  for (auto* const step : {lower_materials, lower_effects, lower_lights, lower_geometry})
    if (auto reason = step(lowered, capabilities); !reason.empty()) return reason;
  return lowered;
}

}  // namespace orbs::scene
