#include "scene/effects.h"
#include "scene/generators.h"
#include "scene/lower_parts.h"

#include <map>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

// The level of group E that tests an effect; "" for what ORB.S has a level for, and for what each interface
// by its indices may have (E1).
const char* level_of(Effect effect) {
  switch (effect) {
    case Effect::ReflectingLight:
      return "E1";
    case Effect::Spectral:
      return "E2";
    case Effect::Polarisation:
      return "E3";
    case Effect::Fluorescence:
      return "E4";
    case Effect::ThinFilm:
      return "E5";
    case Effect::Dispersion:
      return "E6";
    case Effect::MeasuredMetal:
    case Effect::RoughInterface:
    case Effect::AnalyticShape:
    case Effect::Texture:
    case Effect::Ies:
    case Effect::Instancing:
    case Effect::PathClasses:
      return "";
  }
  return "";
}

}  // namespace

std::vector<CalledFeature> features_of_effects(const Scene& scene) {
  std::vector<CalledFeature> features;
  for (const auto& finding : effects(scene).called_for)
    if (const std::string level = level_of(finding.effect); !level.empty())
      features.push_back({level, fmt::format("{} {}", finding.thing, finding.reason)});
  return features;
}

void drop_spectra(Scene& scene) {
  for (auto& material : scene.materials)
    std::visit(
        [](auto& model) {
          if constexpr (requires { model.spectrum; }) model.spectrum.reset();
        },
        material.model);
  for (auto& light : scene.lights) light.spectrum.reset();
  scene.environment_spectrum.reset();
  scene.spectra.clear();
}

void tessellate_spheres(Scene& scene) {
  // The facets' edges lie within 8e-5 radii of the sphere: 0.01 pixel where it fills 300.
  constexpr int kSegments = 256;
  std::map<int, int> mesh_of;  // by material
  for (const auto& sphere : scene.spheres) {
    const auto [mesh, is_new] = mesh_of.try_emplace(sphere.material, static_cast<int>(scene.meshes.size()));
    if (is_new) {
      scene.meshes.push_back(make_sphere({1, kSegments}));
      scene.meshes.back().name = fmt::format("sphere of material {}", sphere.material);
      scene.meshes.back().triangle_materials.assign(scene.meshes.back().triangles.size(), sphere.material);
    }
    const double r = sphere.radius_m;
    scene.instances.push_back(
        {sphere.name, mesh->second, translation(sphere.centre_m) * scaling({r, r, r}), {}});
  }
  scene.spheres.clear();
}

}  // namespace orbs::scene
