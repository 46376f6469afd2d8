#include "importer/surface_detail.h"

#include "importer/gltf_material.h"
#include "importer/textures.h"

#include <algorithm>
#include <optional>

namespace orbs::importer {

namespace {

constexpr double kMostStrength = 100;  // as in a scene file

std::optional<scene::NormalMap> normal_map(Import& import, int index, const std::string& where) {
  const auto& material = material_at(import, index);
  const auto info = normal_info(material);
  const auto use = texture_use(import, info, where, TexelsOf::Numbers);
  if (!use) return std::nullopt;
  const Mat4& m = use->matrix;
  if (m(0, 1) != 0 || m(1, 0) != 0 || !(m(0, 0) > 0) || !(m(1, 1) > 0)) {
    import.report.not_understood("normal maps that a texture transform turns or mirrors",
                                 "the normals of the mesh alone", where);
    return std::nullopt;
  }
  double strength = material.normalTexture.scale;
  if (!(strength >= 0 && strength <= kMostStrength)) {
    import.report.not_understood("normal maps of negative or huge scale", "the nearest scale of 0 to 100",
                                 where);
    strength = std::clamp(strength, 0.0, kMostStrength);
  }
  scene::NormalMap map{*use, strength};
  map.texture.uv_set = second_coordinates(import, index) ? 1 : 0;
  return map;
}

// 3.9.4 of the specification. It says nothing of shadows; ours let light through as they let be seen.
void add_opacity(Import& import, int index, const std::string& where, scene::SurfaceDetail& detail) {
  const auto& material = material_at(import, index);
  if (material.alphaMode != "MASK" && material.alphaMode != "BLEND") return;
  const auto& pbr = material.pbrMetallicRoughness;
  const double factor = pbr.baseColorFactor.size() == 4 ? std::clamp(pbr.baseColorFactor[3], 0.0, 1.0) : 1.0;
  const bool is_mask = material.alphaMode == "MASK";
  // Alpha times the factor is compared with the cutoff: so is alpha with their ratio.
  const double cutoff = !is_mask ? 0 : factor > 0 ? std::max(0.0, material.alphaCutoff / factor) : 2;
  const auto use =
      alpha_use(import, pbr.baseColorTexture, where, is_mask ? std::optional(cutoff) : std::nullopt);
  detail.opacity_texture = use;
  detail.opacity = !is_mask ? factor : use || cutoff <= 1 ? 1 : 0;
  if (is_mask && use)
    import.report.not_understood("alpha masks between their texels",
                                 "each texel is opaque or not, and interpolated then", where);
}

}  // namespace

scene::SurfaceDetail surface_detail(Import& import, int index, bool emits) {
  const auto& material = material_at(import, index);
  const auto where = place("material", material.name, static_cast<std::size_t>(std::max(index, 0)));
  if (emits) {
    if (material.alphaMode == "MASK" || material.alphaMode == "BLEND")
      import.report.not_understood("transparency of what emits", "opaque everywhere", where);
    if (material.normalTexture.index >= 0)
      import.report.not_understood("normal maps of what emits", "they change nothing there", where);
    return {};
  }
  scene::SurfaceDetail detail;
  add_opacity(import, index, where, detail);
  detail.normal_map = normal_map(import, index, where);
  return detail;
}

}  // namespace orbs::importer
