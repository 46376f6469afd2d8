#include "scene/material.h"

#include "scene/load/kind.h"
#include "scene/load/spectra.h"

namespace orbs::scene {

const char* type_name(const MaterialModel& model) {
  return std::visit([](const auto& m) { return m.kType; }, model);
}

const std::optional<TextureUse>& texture_of(const MaterialModel& model) {
  static const std::optional<TextureUse> kNone;
  return std::visit(
      [](const auto& m) -> const std::optional<TextureUse>& {
        if constexpr (requires { m.texture; }) return m.texture;
        return kNone;
      },
      model);
}

std::vector<TextureUse> texture_uses(const Material& material) {
  std::vector<TextureUse> uses;
  if (const auto& use = texture_of(material.model)) uses.push_back(*use);
  const SurfaceDetail& detail = material.detail;
  if (detail.opacity_texture) uses.push_back(*detail.opacity_texture);
  if (detail.normal_map) uses.push_back(detail.normal_map->texture);
  if (detail.bump_map) uses.push_back(detail.bump_map->texture);
  return uses;
}

const std::optional<SpectrumUse>& spectrum_of(const MaterialModel& model) {
  static const std::optional<SpectrumUse> kNone;
  return std::visit(
      [](const auto& m) -> const std::optional<SpectrumUse>& {
        if constexpr (requires { m.spectrum; }) return m.spectrum;
        return kNone;
      },
      model);
}

Material load_material(json::ObjectReader& in, const Names& textures, SpectralData& spectra) {
  Material material;
  material.name = in.text("name");
  const MaterialEntry entry{in, textures, spectra};
  material.model = load_kind<MaterialModel>(in, entry);
  material.detail = load_surface_detail(in, textures);
  in.finish();
  return material;
}

}  // namespace orbs::scene
