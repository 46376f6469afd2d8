#include "scene/material.h"

#include "base/nth.h"
#include "scene/load/kind.h"
#include "scene/load/spectra.h"

#include <fmt/format.h>

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

std::vector<TextureUse> shown_texture_uses(const std::vector<Material>& materials, int index) {
  const Material& material = nth(materials, index);
  auto uses = texture_uses(material);
  if (const auto* blend = std::get_if<Blend>(&material.model))
    for (const auto& part : blend->parts) {
      const auto more = texture_uses(nth(materials, part.material));
      uses.insert(uses.end(), more.begin(), more.end());
    }
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

namespace {

// Only what stands before the blend is loaded already.
void check_part(const json::ObjectReader& in,
                const char* key,
                const Blend::Part& named,
                const std::vector<Material>& before) {
  if (named.material >= static_cast<int>(before.size()))
    in.fail(key, "must name a material that stands before this one");
  const auto& part = before[static_cast<std::size_t>(named.material)];
  if (std::holds_alternative<Emission>(part.model) || std::holds_alternative<Blend>(part.model))
    in.fail(key,
            fmt::format("must name a material that reflects or refracts and is no blend, '{}' is of type {}",
                        part.name, type_name(part.model)));
  if (part.detail != SurfaceDetail{})
    in.fail(key,
            fmt::format("must name a material without opacity and maps of normals, which are those of the "
                        "blend: '{}' has its own",
                        part.name));
}

}  // namespace

Material load_material(json::ObjectReader& in,
                       const Names& textures,
                       SpectralData& spectra,
                       const Names& names,
                       const std::vector<Material>& before) {
  Material material;
  material.name = in.text("name");
  const MaterialEntry entry{in, textures, spectra, names, before};
  material.model = load_kind<MaterialModel>(in, entry);
  if (const auto* blend = std::get_if<Blend>(&material.model)) {
    check_part(in, "first", blend->parts[0], before);
    check_part(in, "second", blend->parts[1], before);
  }
  material.detail = load_surface_detail(in, textures);
  in.finish();
  return material;
}

}  // namespace orbs::scene
