#pragma once

#include "scene/scene.h"

#include <array>
#include <filesystem>
#include <string>

namespace orbs::adapters {

/// Name of the image of a textured material beside a scene file of this stem.
std::string tinted_image_name(int material, const std::string& stem);
/// Names of the images of its channels R, G and B alone.
std::array<std::string, 3> tinted_channel_names(int material, const std::string& stem);

/// Writes the texture of a material (which has one) times the material's colour, the weight of a blend or the
/// roughness that a texture states, as a float EXR of linear
/// Rec.709, for renderers that cannot multiply a texture by a colour. Exact: decoding and tint are per texel,
/// and filtering, which comes later, is linear. It also leaves no question of encoding to the renderer.
/// InputError when a file cannot be read or written.
void write_tinted(const scene::Scene& scene, int material, const std::filesystem::path& file);

/// The same image, with its mirror images (mirrored_image.h), as three grey ones into `folder`, called
/// tinted_channel_names.
void write_tinted_channels(const scene::Scene& scene,
                           int material,
                           const std::filesystem::path& folder,
                           const std::string& stem);

}  // namespace orbs::adapters
