#include "adapters/mitsuba/limits.h"

#include "adapters/format_limits.h"
#include "adapters/material_meshes.h"
#include "adapters/mitsuba/lights.h"
#include "adapters/mitsuba/materials.h"
#include "adapters/mitsuba/meshes.h"
#include "adapters/mitsuba/stokes_frame.h"
#include "scene/effects/effects.h"

#include <algorithm>

#include <fmt/format.h>

namespace orbs::adapters {

namespace {

constexpr const char* kName = "Mitsuba";

// Mitsuba's emitter is dark from behind; ORB.S's emissive surfaces shine from both sides.
std::string back_limit(const scene::Scene& scene, const MaterialMesh& shown) {
  const auto& material = material_at(scene, shown.material);
  if (!std::holds_alternative<scene::Emission>(material.model) || mitsuba::only_camera_sees_light(scene))
    return "";
  if (!is_closed(shown.mesh))
    return fmt::format(
        "mesh '{}' emits ('{}') and is not closed: Mitsuba's emitters shine from one side only",
        shown.mesh.name, material.name);
  const bool inside = std::any_of(shown.places.begin(), shown.places.end(), [&](const Mat4& place) {
    return encloses(shown.mesh, transform_point(inverse(place).value(), scene.camera.position_m));
  });
  if (!inside) return "";
  return fmt::format("the camera is inside of mesh '{}', which emits: Mitsuba's emitters shine outwards only",
                     shown.mesh.name);
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
  std::vector<std::string> reasons = beyond_orbs_limits(scene, kName, mitsuba::beyond_orbs());
  const auto note = [&](const std::string& reason) {
    if (!reason.empty()) reasons.push_back(reason);
  };
  const auto transport = scene::transport(scene);
  std::set<int> textures;
  for (const int index : scene::visible_materials(scene)) {
    const scene::Material& material = material_at(scene, index);
    note(mitsuba::material_limit(material, transport == scene::LightTransport::Polarised));
    if (const auto& use = scene::texture_of(material.model)) textures.insert(use->texture);
  }
  for (const int index : textures) {
    const auto& texture = scene.textures[static_cast<std::size_t>(index)];
    note(wrap_limit(texture, kName));
    if (transport != scene::LightTransport::Rgb) note(spectral_texture_limit(texture, kName));
  }
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    note(mitsuba::light_limit(scene.lights[i], scene::display_name("light", scene.lights[i].name, i)));
  for (const MaterialMesh& shown : material_meshes(scene)) note(back_limit(scene, shown));
  note(stokes_limit(scene));
  return reasons;
}

}  // namespace orbs::adapters
