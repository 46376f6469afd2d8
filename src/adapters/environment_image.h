#pragma once

#include "base/matrix.h"
#include "image/image.h"
#include "scene/scene.h"

/// The environment map of a scene as other formats can hold it: linear radiance, the environment's colour
/// multiplied in, the top row first. The scene must have a map. InputError when its file cannot be read.
namespace orbs::adapters {

/// An image and a matrix that only turns it: what mirrors is done to the image.
struct TurnedEnvironment {
  image::Image image;
  Mat4 matrix;
};
TurnedEnvironment turned_environment(const scene::Scene& scene);

/// The image in the axes of the world, for a format without a matrix: the same texels where the map is turned
/// about Y by whole texels, else sampled anew at twice the size.
image::Image environment_in_world(const scene::Scene& scene);

/// Whether a few texels hold most of the light, as that of a sun: a renderer that does not sample the image
/// by its brightness finds them by chance alone.
bool has_sun(const scene::Scene& scene);

}  // namespace orbs::adapters
