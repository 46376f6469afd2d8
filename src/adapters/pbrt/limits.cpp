#include "adapters/pbrt/limits.h"

#include "adapters/format_limits.h"
#include "adapters/material_meshes.h"
#include "adapters/pbrt/lights.h"
#include "adapters/pbrt/materials.h"
#include "adapters/pbrt/small_light.h"
#include "image/image_io.h"
#include "scene/effects/effects.h"

#include <bit>

#include <fmt/format.h>

namespace orbs::adapters {

namespace {

constexpr const char* kName = "pbrt";

// Conductors of a scene are black from behind.
std::string back_limit(const scene::Scene& scene, const MaterialMesh& shown) {
  const auto& material = material_at(scene, shown.material);
  if (!std::holds_alternative<scene::Conductor>(material.model) || is_closed(shown.mesh)) return "";
  return fmt::format(
      "mesh '{}' is of the conductor '{}' and not closed: pbrt's conductors reflect from behind",
      shown.mesh.name, material.name);
}

std::string reflecting_limit(const scene::Light& light, const std::string& display_name) {
  if (light.reflectance == scene::RgbColour{}) return "";
  return display_name + " reflects where it shines: pbrt's diffuse surfaces reflect on both sides";
}

// pbrt enlarges other images to the next power of two and so blurs their texels.
std::string size_limit(const scene::Texture& texture) {
  const image::Image image = image::read_image(texture.file);
  if (std::has_single_bit(static_cast<unsigned>(image.width)) &&
      std::has_single_bit(static_cast<unsigned>(image.height)))
    return "";
  return fmt::format("texture '{}' has {} x {} pixels: pbrt resamples what is no power of two", texture.name,
                     image.width, image.height);
}

}  // namespace

std::vector<std::string> pbrt_limits(const scene::Scene& scene) {
  std::vector<std::string> reasons = beyond_orbs_limits(scene, kName, pbrt::beyond_orbs());
  const auto note = [&](const std::string& reason) {
    if (!reason.empty()) reasons.push_back(reason);
  };
  const bool is_spectral = scene::transport(scene) != scene::LightTransport::Rgb;
  std::set<int> textures;
  for (const int index : scene::visible_materials(scene)) {
    const scene::Material& material = material_at(scene, index);
    note(pbrt::material_limit(material));
    const auto& use = scene::texture_of(material.model);
    if (use && !std::holds_alternative<scene::Emission>(material.model)) textures.insert(use->texture);
  }
  for (const int index : textures) {
    const scene::Texture& texture = scene.textures[static_cast<std::size_t>(index)];
    note(wrap_limit(texture, kName));
    note(size_limit(texture));
    if (is_spectral) note(spectral_texture_limit(texture, kName));
  }
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const auto name = scene::display_name("light", scene.lights[i].name, i);
    note(pbrt::light_limit(scene.lights[i], name));
    note(reflecting_limit(scene.lights[i], name));
  }
  const auto meshes = material_meshes(scene);
  for (const MaterialMesh& shown : meshes) note(back_limit(scene, shown));
  note(pbrt::small_light_limit(scene, meshes));
  return reasons;
}

}  // namespace orbs::adapters
