#include "adapters/format_limits.h"
#include "adapters/pbrt/pbrt.h"
#include "image/image_io.h"
#include "scene/lower_parts.h"

#include <bit>

#include <fmt/format.h>

namespace orbs::adapters {

namespace {

constexpr const char* kName = "pbrt";
constexpr const char* kMasking = "height-correlated in transmission, too";
constexpr double kLeastAlpha = 1e-3;  // its distribution takes smaller ones for smooth

bool is_grey(scene::Rgb c) { return c.x == c.y && c.y == c.z; }

struct ModelLimit {
  const std::string& name;

  // beyond_orbs_limits has said so.
  std::string operator()(const scene::AppearanceModel auto&) const { return ""; }
  std::string operator()(const scene::Lambert&) const { return ""; }
  std::string operator()(const scene::OrenNayar& m) const {
    return oren_nayar_limit(name, m.roughness, kName);
  }
  std::string operator()(const scene::Emission& m) const {
    if (!m.texture) return "";
    return fmt::format(
        "material '{}' emits through a texture: pbrt's area light neither repeats a picture nor tints it",
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

  std::string coloured(scene::Rgb colour, const char* what) const {
    if (is_grey(colour)) return "";
    return fmt::format(
        "material '{}' is a coloured {}: pbrt's reflectance of metals depends on the angle, and the share of "
        "a full mirror that stands for a constant one has no colour",
        name, what);
  }
  std::string tinted(scene::Rgb colour) const {
    if (colour == scene::Rgb{1, 1, 1}) return "";
    return fmt::format("material '{}' is tinted glass: pbrt's dielectrics have no colour", name);
  }
};

// pbrt enlarges other pictures to the next power of two and so blurs their texels.
std::string size_limit(const scene::Texture& texture) {
  const image::Image picture = image::read_image(texture.file);
  if (std::has_single_bit(static_cast<unsigned>(picture.width)) &&
      std::has_single_bit(static_cast<unsigned>(picture.height)))
    return "";
  return fmt::format("texture '{}' has {} x {} pixels: pbrt resamples what is no power of two", texture.name,
                     picture.width, picture.height);
}

}  // namespace

std::vector<std::string> pbrt_limits(const scene::Scene& scene) {
  std::vector<std::string> reasons = beyond_orbs_limits(scene, kName, {});
  const auto note = [&](const std::string& reason) {
    if (!reason.empty()) reasons.push_back(reason);
  };
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
  }
  for (const scene::Light& light : scene.lights) note(light_limit(light, kName));
  return reasons;
}

}  // namespace orbs::adapters
