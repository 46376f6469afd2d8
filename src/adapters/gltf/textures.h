#pragma once

#include "adapters/gltf/placement.h"
#include "scene/scene.h"

#include <map>
#include <optional>
#include <string>

namespace orbs::adapters::gltf {

/// What glTF has in the texels of an image: sRGB-encoded colours, or plain numbers, as normals are.
enum class TexelsOf { Colours, Numbers };

/// Why the texture cannot be written, "" when it can. Reads the file; InputError when it cannot be read.
std::string texture_limit(const scene::Texture& texture, TexelsOf texels);

/// The texture as the bytes of a PNG of 8 bits as they are in its file, without colour profile and gamma.
/// InputError when the file cannot be read.
std::string texture_png(const scene::Texture& texture);

/// Those of a material's textures.
struct TextureTransforms {
  std::optional<TextureTransform> colour;
  std::optional<TextureTransform> normals;
};

/// Takes the texture matrices away that KHR_texture_transform can say, and returns them by the indices of
/// their materials. Those that stay are for material_meshes(), which applies them to the coordinates: all of
/// a material, where it cannot say one of them.
std::map<int, TextureTransforms> take_texture_transforms(scene::Scene& scene);

/// Why those that stay of a material cannot be applied to the coordinates; "" when they can.
std::string texture_matrices_limit(const scene::Scene& scene, int material);

}  // namespace orbs::adapters::gltf
