#include "scene/effects/features.h"

#include "scene/camera_frame.h"
#include "scene/effects/effects.h"
#include "scene/lights/placement.h"
#include "scene/motion.h"

#include <map>
#include <utility>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

bool has_several_materials(const Mesh& mesh) {
  return std::set<int>(mesh.triangle_materials.begin(), mesh.triangle_materials.end()).size() > 1;
}

// The level of group E that tests an effect; "" for effects that ORB.S has a level for, and for those that
// every boundary by its indices may have (E1).
const char* level_for(Effect effect) {
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
    case Effect::RoughBoundary:
    case Effect::AnalyticShape:
    case Effect::Texture:
    case Effect::Ies:
    case Effect::Instancing:
    case Effect::PathClasses:
    case Effect::Motion:
    case Effect::LightWithoutArea:
    case Effect::Opacity:
    case Effect::TurnedNormals:
    case Effect::EnvironmentMap:
    case Effect::SurfaceLayers:
      return "";
  }
  return "";
}

}  // namespace

std::vector<CalledFeature> features_of_subdivision(const Scene& scene) {
  std::vector<CalledFeature> features;
  std::set<int> seen;
  for (const auto& instance : scene.instances) {
    const auto& mesh = mesh_of(scene, instance);
    if (!mesh.subdivision || !seen.insert(instance.mesh).second) continue;
    features.push_back({"S5", fmt::format("mesh '{}' is a subdivision surface", mesh.name)});
    if (mesh.subdivision->displacement)
      features.push_back({"S6", fmt::format("mesh '{}' is displaced by a formula", mesh.name)});
  }
  return features;
}

std::vector<CalledFeature> features_of_shapes(const Scene& scene) {
  std::vector<CalledFeature> features;
  for (std::size_t i = 0; i < scene.spheres.size(); ++i)
    features.push_back(
        {"S1", display_name("shape", scene.spheres[i].name, i) + " is a sphere by its formula"});
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    const auto name = display_name("shape", scene.shapes[i].name, scene.spheres.size() + i);
    if (std::holds_alternative<CsgForm>(scene.shapes[i].form))
      features.push_back({"S4", name + " is a solid by CSG"});
    for_each_leaf(scene.shapes[i], 0, [&](const Shape& leaf, int) {
      features.push_back(
          {level_of(leaf.form), fmt::format("{} {} {} by its formula", name,
                                            &leaf == &scene.shapes[i] ? "is" : "has", what_is(leaf.form))});
    });
  }
  return features;
}

std::vector<CalledFeature> features_of_geometry(const Scene& scene) {
  std::vector<CalledFeature> features{{"G1", "the scene is made of triangles"},
                                      {"G2", "the scene has a camera"}};
  std::set<int> seen;
  for (const auto& instance : scene.instances) {
    const auto& mesh = mesh_of(scene, instance);
    if (!seen.insert(instance.mesh).second)
      features.push_back({"G3", fmt::format("mesh '{}' appears several times", mesh.name)});
    if (instance.matrix != Mat4{})
      features.push_back({"G3", fmt::format("instance '{}' has a matrix", instance.name)});
    if (!instance.remap.empty())
      features.push_back(
          {has_several_materials(mesh) ? "G5" : "G4",
           fmt::format("instance '{}' changes materials of mesh '{}'", instance.name, mesh.name)});
  }
  for (const auto& part : {features_of_shapes(scene), features_of_subdivision(scene)})
    features.insert(features.end(), part.begin(), part.end());
  for (std::size_t i = 0; i < scene.meshes.size(); ++i)
    if (!seen.contains(static_cast<int>(i)))
      features.push_back(
          {"G3", fmt::format("mesh '{}' is not instanced and must not appear", scene.meshes[i].name)});
  return features;
}

std::vector<CalledFeature> features_of_materials(const Scene& scene) {
  std::vector<CalledFeature> features;
  for (const int index : visible_materials(scene)) {
    const auto& material = material_at(scene, index);
    const auto needed = std::visit([](const auto& model) { return requirement(model); }, material.model);
    const auto note = [&](const char* code, const std::string& what) {
      features.push_back({code, fmt::format("material '{}' {}", material.name, what)});
    };
    note(needed.code, fmt::format("is {}", needed.what));
    const SurfaceDetail& detail = material.detail;
    if (detail.normal_map) note("N1", "has a normal map");
    if (detail.bump_map) note("N2", "has a bump map");
    if (lets_rays_pass(detail)) note("N3", "lets a share of the rays pass");
    for (const TextureUse& use : texture_uses(material)) {
      const Texture& image = texture_at(scene, use);
      if (image.wrap_u == Wrap::Mirror || image.wrap_v == Wrap::Mirror) note("N4", "has a mirrored texture");
      if (image.filter == Filter::Nearest) note("N5", "has a texture that is not interpolated");
      if (use.uv_set != 0) note("N6", "has a texture at the second texture coordinates");
      if (use.matrix != Mat4{}) note("M5", "has a texture matrix");
    }
    const auto& texture = texture_of(material.model);
    if (!texture) continue;
    note(std::holds_alternative<Emission>(material.model) ? "M6" : "M4", "has a texture");
  }
  return features;
}

std::vector<CalledFeature> features_of_lights(const Scene& scene) {
  std::vector<CalledFeature> features;
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const auto& light = scene.lights[i];
    const auto note = [&](const char* requirement, const std::string& what) {
      features.push_back({requirement, fmt::format("{} {}", display_name("light", light.name, i), what)});
    };
    std::visit([&](const auto& shape) { note(shape.kRequirement, std::string("is ") + shape.kWhat); },
               light.shape);
    if (has_area(light.shape) && !is_translation(light.matrix)) note("L3", "is turned or scaled");
    std::visit(
        [&](const auto& shape) {
          if constexpr (requires { shape.kProfileRequirement; })
            if (light.ies) note(shape.kProfileRequirement, "has an IES profile");
        },
        light.shape);
  }
  return features;
}

std::vector<CalledFeature> features_of_environment(const Scene& scene) {
  std::vector<CalledFeature> features;
  if (scene.environment.map) features.push_back({"D5", "the environment is an image"});
  if (!scene.environment.visible_to_camera)
    features.push_back({"D6", "the camera does not see the environment"});
  return features;
}

std::vector<CalledFeature> features_of_effects(const Scene& scene) {
  std::vector<CalledFeature> features;
  for (const auto& finding : effects(scene).called_for)
    if (const std::string level = level_for(finding.effect); !level.empty())
      features.push_back({level, fmt::format("{} {}", finding.object, finding.reason)});
  return features;
}

std::vector<CalledFeature> features_of_motion(const Scene& scene) {
  std::vector<CalledFeature> features;
  if (!has_motion(scene)) return features;
  if (scene.camera.end) features.push_back({"T3", "the camera moves"});
  for (const auto& instance : scene.instances) {
    if (instance.end_matrix) features.push_back({"T1", fmt::format("instance '{}' moves", instance.name)});
    if (const auto& mesh = mesh_of(scene, instance); mesh.end)
      features.push_back({"T2", fmt::format("mesh '{}' changes its shape", mesh.name)});
  }
  return features;
}

std::vector<CalledFeature> features_of_camera(const Scene& scene) {
  std::vector<CalledFeature> features;
  if (has_lens(scene.camera)) features.push_back({"C1", "the camera has a lens"});
  if (is_shifted(scene.camera)) features.push_back({"C3", "the camera's lens is shifted"});
  std::visit(
      [&](const auto& kind) {
        const std::string level = kind.kLevel;
        if (!level.empty()) features.push_back({level, fmt::format("the camera is {}", kind.kWhat)});
      },
      scene.camera.projection);
  return features;
}

std::vector<CalledFeature> features_of_outputs(const Scene& scene) {
  if (scene.outputs.layers.empty()) return {};
  return {{"V1", fmt::format("the image holds the layer '{}'", scene.outputs.layers.front())}};
}

std::vector<CalledFeature> features_of_integrator(const Scene& scene) {
  return std::visit(
      [](const auto& integrator) -> std::vector<CalledFeature> {
        if constexpr (requires { integrator.kLevel; }) return {{integrator.kLevel, integrator.kWhat}};
        return {};
      },
      scene.integrator);
}

std::vector<CalledFeature> features_called_for(const Scene& scene) {
  std::map<std::string, std::string> found;
  for (const auto& features :
       {features_of_geometry(scene), features_of_materials(scene), features_of_lights(scene),
        features_of_environment(scene), features_of_effects(scene), features_of_motion(scene),
        features_of_camera(scene), features_of_integrator(scene), features_of_outputs(scene)})
    for (const auto& feature : features) found.try_emplace(feature.requirement, feature.what);
  std::vector<CalledFeature> out;
  for (const auto& [requirement, what] : found) out.push_back({requirement, what});
  return out;
}

}  // namespace orbs::scene
