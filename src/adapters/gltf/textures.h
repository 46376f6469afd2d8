#pragma once

#include "adapters/gltf/placement.h"
#include "scene/scene.h"

#include <map>
#include <string>

namespace orbs::adapters::gltf {

/// Why the texture cannot be written, "" when it can. Reads the file; InputError when it cannot be read.
std::string texture_limit(const scene::Texture& texture);

/// The texture as the bytes of a PNG of 8 bits, sRGB-encoded, without colour profile and gamma. InputError
/// when the file cannot be read.
std::string texture_png(const scene::Texture& texture);

/// Takes the texture matrices away that KHR_texture_transform can say, and returns them by the indices of
/// their materials. Those that stay are for material_meshes(), which applies them to the coordinates.
std::map<int, TextureTransform> take_texture_transforms(scene::Scene& scene);

}  // namespace orbs::adapters::gltf
