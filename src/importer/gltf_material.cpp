#include "importer/gltf_material.h"

#include "importer/textures.h"
#include "importer/values.h"

namespace orbs::importer {

const tinygltf::Material& material_at(const Import& import, int index) {
  static const tinygltf::Material kDefault = [] {
    tinygltf::Material material;
    material.name = "default of glTF";
    return material;
  }();
  if (index < 0) return kDefault;
  return item(import.source, import.source.model.materials, index, "material", "a mesh");
}

tinygltf::TextureInfo normal_info(const tinygltf::Material& material) {
  const auto& given = material.normalTexture;
  tinygltf::TextureInfo info;
  info.index = given.index;
  info.texCoord = given.texCoord;
  info.extensions = given.extensions;
  return info;
}

int colour_coordinates(const Import& import, int index) {
  const auto& material = material_at(import, index);
  const auto& base = material.pbrMetallicRoughness.baseColorTexture;
  if (base.index >= 0) return coordinate_set(base);
  if (material.emissiveTexture.index >= 0) return coordinate_set(material.emissiveTexture);
  return material.normalTexture.index >= 0 ? coordinate_set(normal_info(material)) : 0;
}

std::optional<int> second_coordinates(const Import& import, int index) {
  const auto& material = material_at(import, index);
  if (material.normalTexture.index < 0) return std::nullopt;
  const int set = coordinate_set(normal_info(material));
  if (set == colour_coordinates(import, index)) return std::nullopt;
  return set;
}

}  // namespace orbs::importer
