#pragma once

#include "image/image.h"
#include "scene/scene.h"

/// IES profiles as pbrt reads them: a square image of the sphere by an equal-area map, of which it takes the
/// nearest texel.
namespace orbs::adapters::pbrt {

/// Candela over the largest candela, 1024 texels a side: 0.1 degrees between two of them.
image::Image profile_image(const scene::IesProfile& profile);

/// From the image's axes, turned as pbrt turns them, to the world: position, and the profile's axes without
/// their lengths.
Mat4 profile_frame(const scene::Light& light);

}  // namespace orbs::adapters::pbrt
