#include "scene/effects/effects.h"

#include "base/error.h"
#include "base/nth.h"
#include "scene/motion.h"
#include "spectra/observer.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

void note(SceneEffects& found, EffectVerdict verdict, const std::string& object) {
  auto& list = verdict.is_called_for ? found.called_for : found.not_called_for;
  list.push_back({verdict.effect, object, std::move(verdict.reason)});
}

bool is_d65(const spectra::Spectrum& light) {
  const auto& d65 = spectra::illuminant("D65");
  constexpr double kRounding = 1e-9;
  const double scale = value_at(light, 560) / value_at(d65, 560);
  auto wavelengths_nm = whole_nanometres();
  wavelengths_nm.insert(wavelengths_nm.end(), light.wavelengths_nm.begin(), light.wavelengths_nm.end());
  return std::all_of(wavelengths_nm.begin(), wavelengths_nm.end(), [&](double nm) {
    return std::fabs(value_at(light, nm) - scale * value_at(d65, nm)) <= kRounding * scale;
  });
}

bool is_dark(const spectra::Spectrum& light) {
  return std::all_of(light.values.begin(), light.values.end(), [](double value) { return value == 0; });
}

// Whether a light's spectrum is more than its colour: not when it is D65, which is what a colour stands for,
// and not where all surfaces scatter all wavelengths alike.
EffectVerdict verdict_on_light(const Scene& scene, const SpectrumUse& use, bool has_coloured_surface) {
  const auto& [name, spectrum] = spectrum_at(scene.spectra, use);
  if (use.scale == 0 || is_dark(spectrum)) return {Effect::Spectral, false, "emits no light"};
  if (is_d65(spectrum))
    return {Effect::Spectral, false,
            fmt::format("has spectrum '{}', which is D65: white says the same", name)};
  if (!has_coloured_surface)
    return {Effect::Spectral, false,
            fmt::format("has spectrum '{}', but every surface treats all wavelengths alike: the colour of "
                        "the light says it all",
                        name)};
  return {Effect::Spectral, true, fmt::format("emits by spectrum '{}', which is not D65", name)};
}

// All effects that the material would call for if a surface showed it.
std::vector<EffectVerdict> verdicts_on(const Scene& scene, const Material& material) {
  auto found = std::visit([&](const auto& m) { return effects(scene.spectra, m); }, material.model);
  if (texture_of(material.model)) found.push_back({Effect::Texture, true, "has a texture"});
  const SurfaceDetail& detail = material.detail;
  if (lets_rays_pass(detail)) found.push_back({Effect::Opacity, true, "lets a share of the rays pass"});
  if (detail.normal_map) found.push_back({Effect::TurnedNormals, true, "has a normal map"});
  if (detail.bump_map) found.push_back({Effect::TurnedNormals, true, "has a bump map"});
  return found;
}

void add_materials(const Scene& scene, SceneEffects& found) {
  const auto visible = visible_materials(scene);
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const auto& material = scene.materials[i];
    const bool is_shown = visible.contains(static_cast<int>(i));
    for (auto& verdict : verdicts_on(scene, material)) {
      if (verdict.is_called_for && !is_shown)
        verdict = {verdict.effect, false, "would, but no surface shows it: it " + verdict.reason};
      note(found, verdict, fmt::format("material '{}'", material.name));
    }
  }
}

void add_lights(const Scene& scene, bool has_colour, SceneEffects& found) {
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const auto& light = scene.lights[i];
    const auto name = display_name("light", light.name, i);
    if (light.spectrum) note(found, verdict_on_light(scene, *light.spectrum, has_colour), name);
    if (light.ies) note(found, {Effect::Ies, true, "has an IES profile"}, name);
    if (!has_area(light.shape))
      note(found, {Effect::LightWithoutArea, true, "has no area: nothing sees it and no ray meets it"}, name);
    if (light.reflectance != RgbColour{})
      note(found, {Effect::ReflectingLight, true, "reflects light as well as emitting it"}, name);
  }
  if (scene.environment.map)
    note(found,
         {Effect::EnvironmentMap, true, "is an image, which light sampling searches for its bright parts"},
         "the environment");
  if (scene.environment.spectrum)
    note(found, verdict_on_light(scene, *scene.environment.spectrum, has_colour), "the environment");
}

void add_emissive_materials(const Scene& scene, bool has_colour, SceneEffects& found) {
  for (const int index : visible_materials(scene)) {
    const auto& material = material_at(scene, index);
    const auto* emission = std::get_if<Emission>(&material.model);
    if (emission != nullptr && emission->spectrum)
      note(found, verdict_on_light(scene, *emission->spectrum, has_colour),
           fmt::format("material '{}'", material.name));
  }
}

void add_geometry(const Scene& scene, SceneEffects& found) {
  std::map<int, int> uses;
  for (const auto& instance : scene.instances) ++uses[instance.mesh];
  for (const auto& [mesh, count] : uses)
    if (count > 1)
      note(found, {Effect::Instancing, true, fmt::format("stands in {} places", count)},
           fmt::format("mesh '{}'", nth(scene.meshes, mesh).name));
  for (std::size_t i = 0; i < scene.spheres.size(); ++i)
    note(found, {Effect::AnalyticShape, true, "is a sphere by its formula"},
         display_name("shape", scene.spheres[i].name, i));
  for (std::size_t i = 0; i < scene.shapes.size(); ++i)
    note(found,
         {Effect::AnalyticShape, true, fmt::format("is {} by its formula", what_is(scene.shapes[i].form))},
         display_name("shape", scene.shapes[i].name, scene.spheres.size() + i));
}

void add_motion(const Scene& scene, SceneEffects& found) {
  if (!has_motion(scene)) return;
  if (scene.camera.end) note(found, {Effect::Motion, true, "moves while the shutter is open"}, "the camera");
  std::set<int> seen;
  for (const auto& instance : scene.instances) {
    const auto& mesh = mesh_of(scene, instance);
    if (instance.end_matrix)
      note(found, {Effect::Motion, true, "moves while the shutter is open"},
           fmt::format("instance '{}'", instance.name));
    if (mesh.end && seen.insert(instance.mesh).second)
      note(found, {Effect::Motion, true, "changes its shape while the shutter is open"},
           fmt::format("mesh '{}'", mesh.name));
  }
}

void add_outputs(const Scene& scene, SceneEffects& found) {
  if (scene.outputs.stokes) note(found, {Effect::Polarisation, true, "holds Stokes vectors"}, "the image");
  if (scene.outputs.path_classes)
    note(found, {Effect::PathClasses, true, "is split by classes of light path"}, "the image");
  if (!scene.outputs.layers.empty())
    note(found, {Effect::SurfaceLayers, true, "holds layers of the surface"}, "the image");
}

}  // namespace

SceneEffects effects(const Scene& scene) {
  SceneEffects found;
  const bool has_colour = has_coloured_surface(scene);
  add_materials(scene, found);
  add_emissive_materials(scene, has_colour, found);
  add_lights(scene, has_colour, found);
  add_geometry(scene, found);
  add_motion(scene, found);
  add_outputs(scene, found);
  const auto by_effect = [](const EffectFinding& a, const EffectFinding& b) { return a.effect < b.effect; };
  std::stable_sort(found.called_for.begin(), found.called_for.end(), by_effect);
  std::stable_sort(found.not_called_for.begin(), found.not_called_for.end(), by_effect);
  return found;
}

bool calls_for(const SceneEffects& found, Effect effect) {
  return std::any_of(found.called_for.begin(), found.called_for.end(),
                     [&](const EffectFinding& finding) { return finding.effect == effect; });
}

std::string_view transport_name(LightTransport transport) {
  switch (transport) {
    case LightTransport::Rgb:
      return "rgb";
    case LightTransport::Spectral:
      return "spectral";
    case LightTransport::Polarised:
      return "polarised";
    case LightTransport::Bispectral:
      return "bispectral";
    case LightTransport::PolarisedBispectral:
      return "polarised-bispectral";
  }
  return "";
}

std::optional<LightTransport> transport_named(std::string_view name) {
  for (const auto transport : kTransports)
    if (transport_name(transport) == name) return transport;
  return std::nullopt;
}

LightTransport transport_for(Effect effect) {
  switch (effect) {
    case Effect::Spectral:
    case Effect::MeasuredMetal:
    case Effect::Dispersion:
    case Effect::ThinFilm:
      return LightTransport::Spectral;
    case Effect::Polarisation:
      return LightTransport::Polarised;
    case Effect::Fluorescence:
      return LightTransport::Bispectral;
    case Effect::RoughBoundary:
    case Effect::ReflectingLight:
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
      return LightTransport::Rgb;
  }
  return LightTransport::Rgb;
}

bool has_coloured_surface(const Scene& scene) {
  const auto visible = visible_materials(scene);
  return std::any_of(visible.begin(), visible.end(),
                     [&](int i) {
                       return std::visit([&](const auto& model) { return is_coloured(scene.spectra, model); },
                                         material_at(scene, i).model);
                     }) ||
         std::any_of(scene.lights.begin(), scene.lights.end(),
                     [](const auto& light) { return !is_grey(light.reflectance); });
}

bool covers(LightTransport richer, LightTransport needed) {
  if (richer == LightTransport::Bispectral && needed == LightTransport::Polarised) return false;
  return richer >= needed;
}

std::string reason_for(const SceneEffects& found) {
  // The last finding in the order of effects makes the transport as rich as it is.
  const auto last = std::find_if(found.called_for.rbegin(), found.called_for.rend(), [](const auto& finding) {
    return transport_for(finding.effect) != LightTransport::Rgb;
  });
  return last == found.called_for.rend() ? "" : fmt::format(" because {} {}", last->object, last->reason);
}

LightTransport transport(const SceneEffects& found) {
  LightTransport needed = LightTransport::Rgb;
  for (const auto& finding : found.called_for) {
    const auto one = transport_for(finding.effect);
    const bool both = std::max(one, needed) == LightTransport::Bispectral &&
                      std::min(one, needed) == LightTransport::Polarised;
    needed = both ? LightTransport::PolarisedBispectral : std::max(one, needed);
  }
  return needed;
}

LightTransport transport(const Scene& scene) { return transport(effects(scene)); }

void refuse_effect(Effect effect,
                   const std::vector<EffectVerdict>& verdicts,
                   const std::string& material,
                   const char* type) {
  for (const auto& verdict : verdicts)
    if (verdict.effect == effect && verdict.is_called_for)
      throw InputError(fmt::format("material '{}' {}, and the type {} has no form without the effect '{}'",
                                   material, verdict.reason, type, effect_name(effect)));
}

namespace {

// Those that are no part of a material's model. Without its image the environment shines everywhere as it
// does where the image is white.
bool leave_out_of_scene(Effect effect, Scene& scene) {
  if (effect == Effect::Motion) scene = at_time(scene, scene.camera.shutter.open);
  if (effect == Effect::EnvironmentMap) scene.environment.map.reset();
  if (effect == Effect::SurfaceLayers) scene.outputs.layers.clear();
  for (auto& [name, model, detail] : scene.materials) {
    if (effect == Effect::Opacity) {
      detail.opacity = 1;
      detail.opacity_texture.reset();
    }
    if (effect == Effect::TurnedNormals) {
      detail.normal_map.reset();
      detail.bump_map.reset();
    }
  }
  return effect == Effect::Motion || effect == Effect::EnvironmentMap || effect == Effect::Opacity ||
         effect == Effect::TurnedNormals || effect == Effect::SurfaceLayers;
}

}  // namespace

bool leave_out(Effect effect, Scene& scene) {
  if (leave_out_of_scene(effect, scene)) return true;
  if (effect != Effect::Dispersion && effect != Effect::MeasuredMetal && effect != Effect::ThinFilm)
    return false;
  for (auto& material : scene.materials)
    std::visit([&](auto& model) { leave_out_of(scene.spectra, effect, material.name, model); },
               material.model);
  return true;
}

}  // namespace orbs::scene
