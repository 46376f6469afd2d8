#include "adapters/povray/limits.h"

#include "adapters/format_limits.h"
#include "adapters/povray/lights.h"
#include "adapters/povray/materials.h"
#include "adapters/povray/shapes.h"

#include <set>

#include <fmt/format.h>

namespace orbs::adapters {

namespace {

std::string texture_limit(const scene::Texture& texture) {
  const std::string type = povray::image_type(texture.file);
  if (type.empty())
    return fmt::format("texture '{}' is a {} file, which POV-Ray does not read", texture.name,
                       texture.file.extension().string());
  if (texture.wrap_u != texture.wrap_v && type != "png")
    return fmt::format(
        "texture '{}' is clamped along one axis only, which the exporter can do for PNG files alone",
        texture.name);
  return "";
}

// Light that a mirror or glass sends to a diffuse surface needs photons, and only light sources emit photons.
bool needs_caustics(const scene::Scene& scene, const std::set<int>& materials) {
  if (scene.trace_depth < 2 || scene.lights.empty()) return false;
  bool has_diffuse = false;
  bool has_specular = false;
  for (const int material : materials) {
    const scene::MaterialModel& model = material_at(scene, material).model;
    has_specular = has_specular || povray::is_photon_target(model);
    has_diffuse = has_diffuse || povray::surface_of(model) == povray::Surface::Diffuse;
  }
  return has_diffuse && has_specular;
}

}  // namespace

std::vector<std::string> povray_limits(const scene::Scene& scene, const PovraySettings& settings) {
  std::vector<std::string> reasons = beyond_orbs_limits(scene, "POV-Ray", povray::beyond_orbs());
  const auto note = [&](const std::string& reason) {
    if (!reason.empty()) reasons.push_back(reason);
  };
  const std::set<int> materials = scene::visible_materials(scene);
  std::set<int> textures;
  for (const int index : materials) {
    const scene::Material& material = material_at(scene, index);
    note(povray::material_limit(material));
    if (const auto& use = scene::texture_of(material.model)) textures.insert(use->texture);
  }
  for (const int texture : textures) note(texture_limit(scene.textures[static_cast<std::size_t>(texture)]));
  for (std::size_t i = 0; i < scene.shapes.size(); ++i)
    note(povray::shape_limit(scene, scene.shapes[i],
                             scene::display_name("shape", scene.shapes[i].name, scene.spheres.size() + i)));
  for (const auto& sphere : scene.spheres)
    if (texture_of(material_at(scene, sphere.material).model))
      note("a sphere by its formula has a texture: POV-Ray's shapes have different texture coordinates");
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    note(povray::light_limit(scene.lights[i], scene::display_name("light", scene.lights[i].name, i)));
  if (settings.photons == 0 && needs_caustics(scene, materials))
    note(
        "a mirror or glass throws light on diffuse surfaces, which takes photons, and they are switched off");
  return reasons;
}

}  // namespace orbs::adapters
