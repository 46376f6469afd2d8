#include "importer/materials.h"

#include "importer/gltf_material.h"
#include "importer/surface_detail.h"
#include "importer/textures.h"
#include "importer/values.h"

#include <algorithm>
#include <set>

namespace orbs::importer {

namespace {

// A material in glTF's own terms, with its extensions.
struct Entry {
  const tinygltf::Material& in;
  std::string where;
  scene::RgbColour base{};
  double metallic = 1;
  double roughness = 1;
  scene::RgbColour emitted{};

  bool has(const char* extension) const { return in.extensions.contains(extension); }
  double number(const char* extension, const char* key, double otherwise) const {
    const auto found = in.extensions.find(extension);
    return found == in.extensions.end() ? otherwise : number_in(found->second, key).value_or(otherwise);
  }
  bool has_key(const char* extension, const char* key) const {
    const auto found = in.extensions.find(extension);
    return found != in.extensions.end() && found->second.IsObject() && found->second.Has(key);
  }
};

double within(double value, double low, double high) { return std::min(std::max(value, low), high); }

Entry entry_of(Import& import, int index, const Shown& shown) {
  const auto& material = material_at(import, index);
  Entry entry{material, place("material", material.name, static_cast<std::size_t>(std::max(index, 0)))};
  const auto& pbr = material.pbrMetallicRoughness;
  const auto& factor = pbr.baseColorFactor;
  if (factor.size() == 4)
    entry.base = scene::RgbColour{factor[0], factor[1], factor[2]} * shown.tint;
  else
    entry.base = shown.tint;
  if (entry.base.x > 1 || entry.base.y > 1 || entry.base.z > 1 || entry.base.x < 0 || entry.base.y < 0 ||
      entry.base.z < 0) {
    import.report.not_understood("base colours beyond [0, 1]", "the nearest colour within", entry.where);
    entry.base = {within(entry.base.x, 0, 1), within(entry.base.y, 0, 1), within(entry.base.z, 0, 1)};
  }
  entry.metallic = within(pbr.metallicFactor * shown.metallic, 0, 1);
  entry.roughness = within(pbr.roughnessFactor * shown.roughness, 0, 1);
  if (material.emissiveFactor.size() == 3) {
    const double strength = entry.number("KHR_materials_emissive_strength", "emissiveStrength", 1);
    entry.emitted =
        scene::RgbColour{std::max(0.0, material.emissiveFactor[0]), std::max(0.0, material.emissiveFactor[1]),
                         std::max(0.0, material.emissiveFactor[2])} *
        std::max(0.0, strength);
  }
  return entry;
}

void name_maps(Import& import, const Entry& entry) {
  auto& report = import.report;
  if (entry.in.occlusionTexture.index >= 0)
    report.not_understood("occlusion maps", "light transport makes the shadows itself", entry.where);
}

// Extensions of materials, and what stands for each. Those of no effect on what is drawn are not among them.
void name_extensions(Import& import, const Entry& entry) {
  static const std::set<std::string> kRead{"KHR_materials_unlit",        "KHR_materials_emissive_strength",
                                           "KHR_materials_transmission", "KHR_materials_volume",
                                           "KHR_materials_ior",          "KHR_materials_specular"};
  for (const auto& [name, value] : entry.in.extensions)
    if (!kRead.contains(name)) import.report.not_understood(name, "as if it were not there", entry.where);
}

bool is_black(scene::RgbColour colour) { return colour == scene::RgbColour{}; }
bool is_white(scene::RgbColour colour) { return colour == scene::RgbColour{1, 1, 1}; }

scene::MaterialModel unlit(Import& import, const Entry& entry) {
  import.report.not_understood("unlit materials (KHR_materials_unlit)",
                               "surfaces that shine in that colour, and light others", entry.where);
  return scene::Emission{entry.base,
                         texture_use(import, entry.in.pbrMetallicRoughness.baseColorTexture, entry.where)};
}

// Ours emits or reflects. What emits everywhere is taken for a lamp; what a texture makes emit here and there
// is taken for what it reflects, unless that is nothing.
std::optional<scene::MaterialModel> emission(Import& import, const Entry& entry) {
  if (is_black(entry.emitted)) return std::nullopt;
  const bool reflects =
      !is_black(entry.base) || entry.number("KHR_materials_specular", "specularFactor", 1) > 0;
  const bool is_textured = entry.in.emissiveTexture.index >= 0;
  if (is_textured && !is_black(entry.base)) {
    import.report.not_understood("emission by a texture on a surface that reflects", "it reflects alone",
                                 entry.where);
    return std::nullopt;
  }
  if (reflects)
    import.report.not_understood("surfaces that emit and reflect", "they emit alone", entry.where);
  return scene::Emission{entry.emitted, texture_use(import, entry.in.emissiveTexture, entry.where)};
}

std::optional<scene::MaterialModel> glass(Import& import, const Entry& entry) {
  const double share = entry.number("KHR_materials_transmission", "transmissionFactor", 0);
  if (share == 0) return std::nullopt;
  const double thickness = entry.number("KHR_materials_volume", "thicknessFactor", 0);
  if (thickness == 0 || share < 1 || entry.has_key("KHR_materials_transmission", "transmissionTexture")) {
    import.report.not_understood(thickness == 0
                                     ? "thin sheets that transmit (KHR_materials_transmission)"
                                     : "surfaces that transmit a part (KHR_materials_transmission)",
                                 "nothing is transmitted", entry.where);
    return std::nullopt;
  }
  if (!is_white(entry.base) || entry.in.pbrMetallicRoughness.baseColorTexture.index >= 0)
    import.report.not_understood("tinted glass", "the tint acts on reflections, too; without textures",
                                 entry.where);
  if (entry.has_key("KHR_materials_volume", "attenuationDistance"))
    import.report.not_understood("glass that absorbs within (KHR_materials_volume)", "clear glass",
                                 entry.where);
  const double ior = within(entry.number("KHR_materials_ior", "ior", 1.5), 0.1, 10);
  constexpr double kSmoothest = 0.01;  // the least roughness of ours; its alpha is the square
  if (entry.roughness < kSmoothest) return scene::Glass{entry.base, ior};
  return scene::RoughGlass{entry.base, ior, entry.roughness * entry.roughness};
}

// What an exporter without a metallic-roughness material of its own writes by way of the extensions.
std::optional<scene::MaterialModel> by_specular(Import& import, const Entry& entry) {
  const double specular = entry.number("KHR_materials_specular", "specularFactor", 1);
  const auto& texture = entry.in.pbrMetallicRoughness.baseColorTexture;
  if (entry.metallic == 0 && specular == 0)
    return scene::Lambert{entry.base, texture_use(import, texture, entry.where)};
  const bool is_even_metal = entry.metallic == 1 && is_white(entry.base) && texture.index < 0;
  // The index 0 makes all of the light be reflected, at every angle, times the specular factor.
  const bool is_even = entry.metallic == 0 && is_black(entry.base) && texture.index < 0 &&
                       entry.has_key("KHR_materials_ior", "ior") &&
                       entry.number("KHR_materials_ior", "ior", 1.5) == 0;
  if (!is_even_metal && !is_even) return std::nullopt;
  const double share = is_even_metal ? 1 : within(specular, 0, 1);
  if (entry.roughness == 0) return scene::Mirror{{share, share, share}};
  if (is_even_metal) return std::nullopt;
  import.report.not_understood("mirrors of index 0 that are rough",
                               "masking is correlated, not a product of two sides", entry.where);
  return scene::Ggx{{share, share, share}, std::max(1e-4, entry.roughness * entry.roughness)};
}

scene::MaterialModel metallic_roughness(Import& import, const Entry& entry) {
  auto& report = import.report;
  if (entry.metallic < 1) {
    if (entry.number("KHR_materials_specular", "specularFactor", 1) != 1 ||
        entry.has_key("KHR_materials_specular", "specularColorFactor") ||
        entry.has_key("KHR_materials_specular", "specularTexture") ||
        entry.has_key("KHR_materials_specular", "specularColorTexture"))
      report.not_understood("strength of reflections (KHR_materials_specular)", "reflections of strength 1",
                            entry.where);
    if (entry.number("KHR_materials_ior", "ior", 1.5) != 1.5)
      report.not_understood("index of refraction (KHR_materials_ior)", "the index 1.5", entry.where);
  }
  constexpr double kSmoothest = 0.01;
  if (entry.roughness < kSmoothest)
    report.not_understood("roughness below 0.01", "the roughness 0.01", entry.where);
  return scene::MetallicRoughness{
      entry.base, texture_use(import, entry.in.pbrMetallicRoughness.baseColorTexture, entry.where),
      entry.metallic, std::max(kSmoothest, entry.roughness)};
}

scene::MaterialModel model_of(Import& import, const Entry& entry) {
  if (entry.has("KHR_materials_unlit")) return unlit(import, entry);
  if (const auto emitting = emission(import, entry)) return *emitting;
  const auto clear = glass(import, entry);
  // Clear glass shows both of its sides anyway.
  if (clear) return *clear;
  if (!entry.in.doubleSided)
    import.report.not_understood("materials that show their front alone", "seen from both sides",
                                 entry.where);
  if (const auto plain = by_specular(import, entry)) return *plain;
  return metallic_roughness(import, entry);
}

}  // namespace

int material_for(Import& import, int index, const Shown& shown) {
  const std::array<double, 6> key{
      static_cast<double>(index), shown.tint.x, shown.tint.y, shown.tint.z, shown.metallic, shown.roughness};
  const auto known = import.materials.find(key);
  if (known != import.materials.end()) return known->second;
  const Entry entry = entry_of(import, index, shown);
  name_maps(import, entry);
  name_extensions(import, entry);
  auto model = model_of(import, entry);
  const auto name = import.material_names.add(entry.in.name, fmt::format("material {}", index));
  const auto detail = surface_detail(import, index, std::holds_alternative<scene::Emission>(model));
  import.scene.materials.push_back({name, std::move(model), detail});
  const int added = static_cast<int>(import.scene.materials.size()) - 1;
  import.materials[key] = added;
  return added;
}

}  // namespace orbs::importer
