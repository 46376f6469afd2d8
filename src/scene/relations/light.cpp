#include "scene/relations/light.h"

#include "scene/effects/effects.h"

namespace orbs::scene {

namespace {

void multiply(RgbColour& colour, std::optional<SpectrumUse>& spectrum, double factor) {
  colour *= factor;
  if (spectrum) spectrum->scale *= factor;
}

void rotate(RgbColour& colour) { colour = {colour.y, colour.z, colour.x}; }

}  // namespace

void multiply_emission(Light& light, double factor) { multiply(light.radiance, light.spectrum, factor); }

Scene with_emission_times(const Scene& scene, double factor) {
  Scene out = scene;
  multiply(out.environment.radiance, out.environment.spectrum, factor);
  for (auto& light : out.lights) multiply_emission(light, factor);
  for (auto& material : out.materials)
    if (auto* emission = std::get_if<Emission>(&material.model))
      multiply(emission->radiance, emission->spectrum, factor);
  return out;
}

std::variant<Scene, std::string> with_rotated_channels(const Scene& scene) {
  if (!scene.spectra.empty() || transport(effects(scene)) != LightTransport::Rgb)
    return "its colours are spectra, which have no three channels to exchange";
  Scene out = scene;
  if (scene.environment.map) return "its environment is an image, whose file keeps its channels";
  rotate(out.environment.radiance);
  for (auto& light : out.lights) {
    rotate(light.radiance);
    rotate(light.reflectance);
  }
  for (auto& material : out.materials) {
    if (texture_of(material.model)) return "it has textures, whose files keep their channels";
    std::visit(
        [](auto& model) {
          if constexpr (requires { model.reflectance; }) rotate(model.reflectance);
          if constexpr (requires { model.colour; }) rotate(model.colour);
          if constexpr (requires { model.radiance; }) rotate(model.radiance);
        },
        material.model);
  }
  return out;
}

}  // namespace orbs::scene
