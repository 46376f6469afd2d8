#include "scene/load/texture_checks.h"

#include "base/error.h"
#include "image/image_io.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

// Reflectances and opacities lie in [0, 1].
bool multiplies_share(const Scene& scene, std::size_t texture) {
  const auto is_it = [&](const std::optional<TextureUse>& use) {
    return use && static_cast<std::size_t>(use->texture) == texture;
  };
  return std::any_of(scene.materials.begin(), scene.materials.end(), [&](const Material& material) {
    return (is_it(texture_of(material.model)) && !std::holds_alternative<Emission>(material.model)) ||
           is_it(material.detail.opacity_texture);
  });
}

std::string texel_problem(const image::Image& image, bool is_share) {
  const auto channels = image::texture_channels(image);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (const auto channel : channels) {
        const float value = image.at(x, y, channel);
        const char* wanted = !std::isfinite(value)   ? "texels must be finite"
                             : value < 0             ? "texels must not be negative"
                             : is_share && value > 1 ? "those of a reflectance must not be above 1"
                                                     : nullptr;
        if (wanted != nullptr)
          return fmt::format("texel ({}, {}), counted from 0 at the top left, has {} in channel {}; {}", x, y,
                             value, image.channels[channel], wanted);
      }
  return "";
}

}  // namespace

std::string texture_problem(const Scene& scene, std::size_t texture) {
  const auto& file = scene.textures[texture].file;
  try {
    if (!image::is_float_format(file)) return "";
    const auto image = image::read_image(file);
    const auto problem = texel_problem(image, multiplies_share(scene, texture));
    return problem.empty() ? "" : fmt::format("{}: {}", file.string(), problem);
  } catch (const InputError& e) {
    return e.what();
  }
}

namespace {

// Of the triangles of one material; nothing where they differ.
using OneUv = std::optional<Vec2f>;

std::map<int, OneUv> uvs_by_material(const Mesh& mesh) {
  std::map<int, OneUv> found;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto corners = mesh.triangles[i];
    const auto known = found.try_emplace(mesh.triangle_materials[i], mesh.uvs[corners[0]]).first;
    OneUv& uv = known->second;
    for (const auto corner : corners)
      if (uv && !(mesh.uvs[corner] == *uv)) uv.reset();
  }
  return found;
}

}  // namespace

std::vector<std::string> flat_texture_warnings(const Scene& scene,
                                               const std::vector<std::string>& mesh_places) {
  std::map<int, std::map<int, OneUv>> known;  // by mesh and its materials
  std::set<std::pair<int, int>> told;         // mesh and the material that it shows
  std::vector<std::string> warnings;
  if (scene.textures.empty()) return warnings;
  for (const auto& instance : scene.instances) {
    const auto [uvs, is_new] = known.try_emplace(instance.mesh);
    if (is_new) uvs->second = uvs_by_material(mesh_of(scene, instance));
    for (const auto& [own, uv] : uvs->second) {
      const int shown = remapped(instance, own);
      if (!uv || shown_texture_uses(scene.materials, shown).empty()) continue;
      if (!told.insert({instance.mesh, shown}).second) continue;
      warnings.push_back(fmt::format(
          "{}: mesh '{}' shows the textured material '{}', and its texture coordinates there are absent or all "
          "({}, {}): the texture is one texel everywhere",
          nth(mesh_places, instance.mesh), mesh_of(scene, instance).name, material_at(scene, shown).name,
          uv->x, uv->y));
    }
  }
  return warnings;
}

}  // namespace orbs::scene
