#include "adapters/closed_mesh.h"
#include "adapters/format_limits.h"
#include "adapters/parts.h"
#include "adapters/pbrt/pbrt.h"
#include "image/image_io.h"
#include "scene/called.h"
#include "scene/effects.h"
#include "scene/lower_parts.h"

#include <bit>

#include <fmt/format.h>

namespace orbs::adapters {

namespace {

constexpr const char* kName = "pbrt";
constexpr const char* kMasking = "height-correlated in transmission, too";
constexpr double kLeastAlpha = 1e-3;  // its distribution takes smaller ones for smooth

const BeyondOrbs& beyond_orbs() {
  static const BeyondOrbs kLevels{{"E1", "E2", "E6"},
                                  {{"E3", "pbrt carries no polarisation"},
                                   {"E4", "pbrt has no fluorescence"},
                                   {"E5", "pbrt has no thin films"}}};
  return kLevels;
}

struct ModelLimit {
  const std::string& name;

  // beyond_orbs_limits has said so.
  std::string operator()(const scene::Polariser&) const { return ""; }
  std::string operator()(const scene::Retarder&) const { return ""; }
  std::string operator()(const scene::Fluorescent&) const { return ""; }
  std::string operator()(const scene::Conductor& m) const { return m.roughness ? rough(*m.roughness) : ""; }
  std::string operator()(const scene::Dielectric& m) const { return m.roughness ? rough(*m.roughness) : ""; }
  std::string operator()(const scene::Lambert&) const { return ""; }
  std::string operator()(const scene::OrenNayar& m) const {
    return oren_nayar_limit(name, m.roughness, kName);
  }
  std::string operator()(const scene::Emission& m) const {
    if (!m.texture) return "";
    return fmt::format(
        "material '{}' emits through a texture: pbrt's area light neither repeats an image nor tints it",
        name);
  }
  std::string operator()(const scene::Mirror& m) const { return coloured(m.reflectance, "mirror"); }
  std::string operator()(const scene::Ggx& m) const {
    const std::string reason = alpha_limit(name, m.alpha, kName, kLeastAlpha);
    return reason.empty() ? coloured(m.colour, "glossy reflector") : reason;
  }
  std::string operator()(const scene::Glass& m) const { return tinted(m.colour); }
  std::string operator()(const scene::RoughGlass& m) const {
    if (const auto reason = alpha_limit(name, m.alpha, kName, kLeastAlpha); !reason.empty()) return reason;
    if (const auto reason = masking_limit(name, m.alpha, kName, kMasking); !reason.empty()) return reason;
    return tinted(m.colour);
  }

  std::string rough(const scene::Roughness& roughness) const {
    if (roughness.distribution != scene::Distribution::Ggx)
      return fmt::format("material '{}' has Beckmann's distribution: pbrt has GGX alone", name);
    const std::string reason = alpha_limit(name, roughness.alpha, kName, kLeastAlpha);
    return reason.empty() ? masking_limit(name, roughness, kName, false) : reason;
  }
  std::string coloured(scene::RgbColour colour, const char* what) const {
    if (scene::is_grey(colour)) return "";
    return fmt::format(
        "material '{}' is a coloured {}: pbrt's reflectance of metals depends on the angle, and the "
        "share of a full mirror that stands for a constant one has no colour",
        name, what);
  }
  std::string tinted(scene::RgbColour colour) const {
    if (colour == scene::RgbColour{1, 1, 1}) return "";
    return fmt::format("material '{}' is tinted glass: pbrt's dielectrics have no colour", name);
  }
};

// Scenes have conductors that are black from behind.
std::string back_limit(const scene::Scene& scene, const Part& part) {
  const auto& material = scene.materials[static_cast<std::size_t>(part.material)];
  if (!std::holds_alternative<scene::Conductor>(material.model) || is_closed(part.mesh)) return "";
  return fmt::format(
      "mesh '{}' is of the conductor '{}' and not closed: pbrt's conductors reflect from behind",
      part.mesh.name, material.name);
}

std::string reflecting_limit(const scene::Light& light, const std::string& called) {
  if (light.reflectance == scene::RgbColour{}) return "";
  return called + " reflects where it shines: pbrt's diffuse surfaces reflect on both sides";
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
  std::vector<std::string> reasons = beyond_orbs_limits(scene, kName, beyond_orbs());
  const auto note = [&](const std::string& reason) {
    if (!reason.empty()) reasons.push_back(reason);
  };
  const bool is_spectral = scene::transport(scene) != scene::LightTransport::Rgb;
  std::set<int> textures;
  for (const int index : scene::visible_materials(scene)) {
    const scene::Material& material = scene.materials[static_cast<std::size_t>(index)];
    note(std::visit(ModelLimit{material.name}, material.model));
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
    const auto called = scene::called("light", scene.lights[i].name, i);
    note(light_limit(scene.lights[i], called, kName));
    note(reflecting_limit(scene.lights[i], called));
  }
  for (const Part& part : parts_of(scene)) note(back_limit(scene, part));
  return reasons;
}

}  // namespace orbs::adapters
