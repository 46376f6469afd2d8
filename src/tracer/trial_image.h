#pragma once

#include "image/image.h"
#include "tracer/world/world.h"

#include <array>

/// Small trial images, which decide whether a technique is worth its time in a scene. The decisions are
/// deterministic: they count samples, not seconds.
namespace orbs::tracer {

/// The same small image with different seeds.
struct Trial {
  std::array<image::Image, 2> images;
  double light_path_contributions = 0;  // to a pixel, in the first image
};

/// `side`: pixels of the longer side. The world's camera is the same afterwards. `threads` as in
/// RenderSettings.
Trial trial_of(World& world, int side, int threads);

/// The factor that takes the mean of all values of both trials to that of a well exposed photograph, so that
/// decisions do not depend on the unit of radiance.
float exposure_of(const Trial& a, const Trial& b);

/// Variance of one image, exposed, display-encoded and summed over means of block x block pixels.
double noise_of(const Trial& trial, float exposure, int block);

/// Squared difference of the means of both, summed likewise. Its factors have independent noise, which
/// averages out of the product.
double squared_bias(const Trial& a, const Trial& b, float exposure, int block);

/// Sum of all values of the first image.
double light_of(const Trial& trial);

}  // namespace orbs::tracer
