#pragma once

#include "image/image.h"
#include "scene/scene.h"

#include <filesystem>
#include <string>

/// Images of what a surface has beside its material's model: float EXRs that leave no question of encoding
/// and scale to the renderer.
namespace orbs::adapters {

/// The texels of a texture as linear numbers, whatever its file holds.
image::Image linear_texels(const scene::Texture& texture);

/// Whether the images hold the mirror images of mirrored textures, too (mirrored_image.h).
enum class MirrorImages { None, Beside };

/// Names beside a scene file of this stem. The opacity is grey: the largest channel of its texture times its
/// number. Heights are grey, in metres of the world.
std::string opacity_image_name(int material, const std::string& stem);
std::string height_image_name(int material, const std::string& stem);
/// Normals by 2 c - 1 in red, green and blue, the strength applied; mirrored ones with the other sign of
/// green.
std::string normal_image_name(int material, const std::string& stem, bool is_mirrored);

/// Writes those that the material calls for. InputError when a file cannot be read or written.
void write_detail_images(const scene::Scene& scene,
                         int material,
                         const std::filesystem::path& scene_file,
                         MirrorImages mirror_images);

}  // namespace orbs::adapters
