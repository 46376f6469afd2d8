#include "adapters/format_limits.h"
#include "adapters/mitsuba/closed_mesh.h"
#include "adapters/mitsuba/mitsuba.h"
#include "adapters/parts.h"
#include "scene/lower_parts.h"

#include <algorithm>

#include <fmt/format.h>

namespace orbs::adapters {

namespace {

constexpr const char* kName = "Mitsuba";
constexpr const char* kMasking = "a product of two sides";
constexpr double kLeastAlpha = 1e-4;  // its MicrofacetDistribution raises smaller ones to this

struct ModelLimit {
  const std::string& name;

  // beyond_orbs_limits has said so.
  std::string operator()(const scene::AppearanceModel auto&) const { return ""; }
  std::string operator()(const scene::Lambert&) const { return ""; }
  std::string operator()(const scene::Mirror&) const { return ""; }
  std::string operator()(const scene::Glass&) const { return ""; }
  std::string operator()(const scene::OrenNayar& m) const {
    return oren_nayar_limit(name, m.roughness, kName);
  }
  // Light sampling on a textured emitter picks a texel and asks the mesh for the one point with these
  // coordinates: repeated or missing ones break it.
  std::string operator()(const scene::Emission& m) const {
    if (!m.texture) return "";
    return fmt::format(
        "material '{}' emits through a texture: Mitsuba samples that by inverting the texture coordinates, "
        "which must then be within [0, 1] and used once",
        name);
  }
  std::string operator()(const scene::Ggx& m) const { return rough(m.alpha); }
  std::string operator()(const scene::RoughGlass& m) const { return rough(m.alpha); }

  std::string rough(double alpha) const {
    const std::string reason = alpha_limit(name, alpha, kName, kLeastAlpha);
    return reason.empty() ? masking_limit(name, alpha, kName, kMasking) : reason;
  }
};

// Its emitter is dark from behind; ORB.S's emissive surfaces shine from both sides.
std::string back_limit(const scene::Scene& scene, const Part& part) {
  const auto& material = scene.materials[static_cast<std::size_t>(part.material)];
  if (!std::holds_alternative<scene::Emission>(material.model)) return "";
  if (!mitsuba::is_closed(part.mesh))
    return fmt::format(
        "mesh '{}' emits ('{}') and is not closed: Mitsuba's emitters shine from one side only",
        part.mesh.name, material.name);
  const bool inside = std::any_of(part.places.begin(), part.places.end(), [&](const Mat4& place) {
    return mitsuba::encloses(part.mesh, transform_point(inverse(place).value(), scene.camera.position_m));
  });
  if (!inside) return "";
  return fmt::format("the camera is inside of mesh '{}', which emits: Mitsuba's emitters shine outwards only",
                     part.mesh.name);
}

}  // namespace

std::vector<std::string> mitsuba_limits(const scene::Scene& scene) {
  std::vector<std::string> reasons = beyond_orbs_limits(scene, kName);
  const auto note = [&](const std::string& reason) {
    if (!reason.empty()) reasons.push_back(reason);
  };
  std::set<int> textures;
  for (const int index : scene::visible_materials(scene)) {
    const scene::Material& material = scene.materials[static_cast<std::size_t>(index)];
    note(std::visit(ModelLimit{material.name}, material.model));
    if (const auto& use = scene::texture_of(material.model)) textures.insert(use->texture);
  }
  for (const int index : textures) note(wrap_limit(scene.textures[static_cast<std::size_t>(index)], kName));
  for (const scene::Light& light : scene.lights) note(light_limit(light, kName));
  for (const Part& part : parts_of(scene)) note(back_limit(scene, part));
  return reasons;
}

}  // namespace orbs::adapters
