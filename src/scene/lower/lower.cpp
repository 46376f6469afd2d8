#include "scene/lower/lower.h"

#include "scene/effects/effects.h"
#include "scene/effects/features.h"
#include "scene/lower/effects.h"
#include "scene/lower/geometry.h"
#include "scene/lower/material.h"

#include <fmt/format.h>

namespace orbs::scene {

namespace {

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
    const auto problem =
        std::visit([&](const auto& shape) { return beyond_levels(shape, light.matrix); }, light.shape);
    if (!problem.empty()) return display_name("light", light.name, i) + " " + problem;
    if (capabilities.contains("L3")) continue;
    const auto moved = without_matrix(light);
    if (!moved)
      return display_name("light", light.name, i) +
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

// Their triangles are there already.
void drop_subdivision(Scene& scene, const Capabilities& capabilities) {
  for (auto& mesh : scene.meshes)
    if (mesh.subdivision &&
        !(capabilities.contains("S5") && (capabilities.contains("S6") || !mesh.subdivision->displacement)))
      mesh.subdivision.reset();
}

std::string lower_geometry(Scene& scene, const Capabilities& capabilities) {
  drop_subdivision(scene, capabilities);
  if (!capabilities.contains("S1")) tessellate_spheres(scene);
  for (const char* level : {"S1", "S2"})
    if (!capabilities.contains(level)) tessellate_shapes(scene, level);
  if (const auto reason = lacking(features_of_shapes(scene), capabilities); !reason.empty()) return reason;
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

std::variant<Scene, std::string> lower(const Scene& scene, const Capabilities& capabilities) {
  Scene lowered = scene;
  if (auto reason = lacking(features_of_integrator(scene), capabilities); !reason.empty()) return reason;
  for (auto* const step : {lower_materials, lower_effects, lower_lights, lower_geometry})
    if (auto reason = step(lowered, capabilities); !reason.empty()) return reason;
  return lowered;
}

}  // namespace orbs::scene
