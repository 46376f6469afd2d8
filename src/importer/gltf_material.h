#pragma once

#include "importer/import.h"

#include <optional>

/// Materials as glTF has them, and which of a mesh's coordinates their textures use.
namespace orbs::importer {

/// glTF's material, -1 its default one.
const tinygltf::Material& material_at(const Import& import, int index);

/// The normal map in the form of other textures: the library has a type of its own for it.
tinygltf::TextureInfo normal_info(const tinygltf::Material& material);

/// The set of coordinates that the colour texture of the material uses; that of its normal map without one.
int colour_coordinates(const Import& import, int index);

/// The set of coordinates that the normal map of the material uses, if that is another than the colour's.
std::optional<int> second_coordinates(const Import& import, int index);

}  // namespace orbs::importer
