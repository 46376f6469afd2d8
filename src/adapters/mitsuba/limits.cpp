#include "adapters/closed_mesh.h"
#include "adapters/format_limits.h"
#include "adapters/mitsuba/mitsuba.h"
#include "adapters/mitsuba/stokes_frame.h"
#include "adapters/parts.h"
#include "scene/called.h"
#include "scene/effects.h"
#include "scene/lower_parts.h"

#include <algorithm>

#include <fmt/format.h>

namespace orbs::adapters {

namespace {

constexpr const char* kName = "Mitsuba";
constexpr const char* kMasking = "a product of two sides";
constexpr double kLeastAlpha = 1e-4;  // its MicrofacetDistribution raises smaller ones to this

const BeyondOrbs& beyond_orbs() {
  static const BeyondOrbs kLevels{{"E1", "E2", "E3"},
                                  {{"E4", "Mitsuba has no fluorescence"},
                                   {"E5", "Mitsuba has no thin films"},
                                   {"E6", "Mitsuba's dielectrics have one index for all wavelengths"}}};
  return kLevels;
}

struct ModelLimit {
  const std::string& name;
  bool is_polarised = false;  // the scene is for scalar_spectral_polarized

  // beyond_orbs_limits has said so.
  std::string operator()(const scene::Fluorescent&) const { return ""; }
  std::string operator()(const scene::Lambert&) const { return ""; }
  std::string operator()(const scene::Glass&) const { return ""; }
  std::string operator()(const scene::Polariser&) const { return ""; }
  std::string operator()(const scene::OrenNayar& m) const {
    return oren_nayar_limit(name, m.roughness, kName);
  }
  // Light sampling on a textured emitter picks a texel and asks the mesh for the one point with these
  // coordinates: repeated or missing ones break it.
  std::string operator()(const scene::Emission& m) const {
    if (!m.texture) return "";
    return fmt::format(
        "material '{}' emits through a texture: Mitsuba samples that by inverting the texture "
        "coordinates, which must then be within [0, 1] and used once",
        name);
  }
  // It is a conductor of n = 0 and k = 1, whose reflectance is 1 but whose phases differ from angle to angle.
  std::string operator()(const scene::Mirror&) const { return full_mirror(); }
  std::string operator()(const scene::Ggx& m) const {
    const std::string reason = rough(m.alpha);
    return reason.empty() ? full_mirror() : reason;
  }
  std::string operator()(const scene::RoughGlass& m) const {
    const std::string reason = rough(m.alpha);
    return reason.empty() ? rough_glass() : reason;
  }
  std::string operator()(const scene::Conductor& m) const { return m.roughness ? rough(*m.roughness) : ""; }
  std::string operator()(const scene::Dielectric& m) const {
    if (!m.roughness) return "";
    const std::string reason = rough(*m.roughness);
    return reason.empty() ? rough_glass() : reason;
  }
  // retarder.cpp there multiplies the retardance by the cosine of the angle.
  std::string operator()(const scene::Retarder& m) const {
    return fmt::format(
        "material '{}' retards by {} degrees at all angles: Mitsuba's retarder falls off with the cosine "
        "of the angle of incidence",
        name, m.retardance_deg);
  }

  std::string rough(double alpha) const {
    const std::string reason = alpha_limit(name, alpha, kName, kLeastAlpha);
    return reason.empty() ? masking_limit(name, alpha, kName, kMasking) : reason;
  }
  std::string rough(const scene::Roughness& roughness) const {
    const std::string reason = alpha_limit(name, roughness.alpha, kName, kLeastAlpha);
    return reason.empty() ? masking_limit(name, roughness, kName, true) : reason;
  }
  std::string rough_glass() const {
    if (!is_polarised) return "";
    return fmt::format("material '{}' is rough glass in polarised light: Mitsuba's forgets the polarisation",
                       name);
  }
  std::string full_mirror() const {
    if (!is_polarised) return "";
    return fmt::format(
        "material '{}' is a full mirror in polarised light: Mitsuba's shifts the phases of both "
        "polarisations as a metal would",
        name);
  }
};

// Its emitter is dark from behind; ORB.S's emissive surfaces shine from both sides.
std::string back_limit(const scene::Scene& scene, const Part& part) {
  const auto& material = scene.materials[static_cast<std::size_t>(part.material)];
  if (!std::holds_alternative<scene::Emission>(material.model)) return "";
  if (!is_closed(part.mesh))
    return fmt::format(
        "mesh '{}' emits ('{}') and is not closed: Mitsuba's emitters shine from one side only",
        part.mesh.name, material.name);
  const bool inside = std::any_of(part.places.begin(), part.places.end(), [&](const Mat4& place) {
    return encloses(part.mesh, transform_point(inverse(place).value(), scene.camera.position_m));
  });
  if (!inside) return "";
  return fmt::format("the camera is inside of mesh '{}', which emits: Mitsuba's emitters shine outwards only",
                     part.mesh.name);
}

std::string stokes_limit(const scene::Scene& scene) {
  const double turn_deg = mitsuba::stokes_frame_turn_deg(scene.camera);
  if (!scene.outputs.stokes || turn_deg <= mitsuba::kMostFrameTurn_deg) return "";
  return fmt::format(
      "the image holds Stokes vectors: Mitsuba measures them from the direction across ray and camera's "
      "up, which in the corners lies {:.1f} degrees from the camera's horizontal",
      turn_deg);
}

}  // namespace

std::vector<std::string> mitsuba_limits(const scene::Scene& scene) {
  std::vector<std::string> reasons = beyond_orbs_limits(scene, kName, beyond_orbs());
  const auto note = [&](const std::string& reason) {
    if (!reason.empty()) reasons.push_back(reason);
  };
  const auto transport = scene::transport(scene);
  std::set<int> textures;
  for (const int index : scene::visible_materials(scene)) {
    const scene::Material& material = scene.materials[static_cast<std::size_t>(index)];
    note(
        std::visit(ModelLimit{material.name, transport == scene::LightTransport::Polarised}, material.model));
    if (const auto& use = scene::texture_of(material.model)) textures.insert(use->texture);
  }
  for (const int index : textures) {
    const auto& texture = scene.textures[static_cast<std::size_t>(index)];
    note(wrap_limit(texture, kName));
    if (transport != scene::LightTransport::Rgb) note(spectral_texture_limit(texture, kName));
  }
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    note(light_limit(scene.lights[i], scene::called("light", scene.lights[i].name, i), kName));
  for (const Part& part : parts_of(scene)) note(back_limit(scene, part));
  note(stokes_limit(scene));
  return reasons;
}

}  // namespace orbs::adapters
