#pragma once

#include "image/image.h"
#include "tracer/render/rendering.h"
#include "tracer/world/world.h"

#include <array>
#include <optional>

/// Small trial images, which decide whether a technique is worth its time in a scene. The decisions are
/// deterministic: they count samples, not seconds.
namespace orbs::tracer {

/// The same small image with different seeds.
struct Trial {
  std::array<image::Image, 2> images;
  double light_path_contributions = 0;  // to a pixel, in the first image
  RenderTime time;
};

/// What one trial image may have.
struct TrialSize {
  int width = 0;
  int height = 0;
  int samples_per_pixel = 0;
};

/// Sizes of `images` trial images of a world, which trace at most `share` of the camera paths of a render
/// together. A pixel has as many samples as one of the render, as far as that goes: noise that comes from few
/// bright samples grows otherwise than by their number. Nothing if too little is left to decide by.
std::optional<TrialSize> trial_size(const Camera& camera,
                                    const RenderSettings& settings,
                                    double share,
                                    int images);

/// The world's camera is the same afterwards. Of the settings, the threads and the sampler count.
Trial trial_of(World& world, const TrialSize& size, const RenderSettings& settings);

/// How far each of two techniques is off, relative to the light of each pixel: the mean over the pixels of a
/// relative squared error r is computed as of r / (1 + r), so that single bright samples do not decide, and
/// is given back as r. Light that only one of them finds is an error of the other.
struct RelativeErrors {
  double first = 0;
  double second = 0;
};
RelativeErrors relative_errors(const Trial& first, const Trial& second);

/// The variance of the first technique over that of the second, as in the typical pixel: each counts the
/// same, however noisy it is with both, as the edges of lights are. For techniques that find the same light;
/// rare bright samples are not seen. One if no pixel has noise.
double typical_variance_ratio(const Trial& first, const Trial& second);

}  // namespace orbs::tracer
