#pragma once

#include "base/vec.h"
#include "image/image.h"
#include "scene/texture.h"

/// Mirrored textures for renderers whose images repeat and are not mirrored: beside the image stands its
/// mirror image along each mirrored axis, both are looked up at half the coordinate, and they repeat. That is
/// exact: texels at the seams have the same neighbours.
namespace orbs::adapters {

bool is_mirrored(const scene::Texture& texture);

/// The texture with axes that repeat in the place of mirrored ones.
scene::Texture unmirrored(scene::Texture texture);

/// What the texture coordinates are multiplied by then: 1/2 along mirrored axes, else 1.
Vec2d unmirrored_uv_scale(const scene::Texture& texture);

/// The image with its mirror images, all channels.
image::Image with_mirror_images(const image::Image& given, const scene::Texture& texture);

}  // namespace orbs::adapters
