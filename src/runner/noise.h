#pragma once

#include "image/image.h"
#include "metrics/mask.h"

#include <optional>
#include <string>

namespace orbs::runner {

/// The mean squared error that the noise of `image` alone is expected to cause in psnr_srgb8 (in steps of
/// 1/255, squared), from its "variance.R/G/B" channels: the variance of the mean goes through the slope of
/// the sRGB curve at the pixel's value in `values` (delta method), up to the largest error that the clamp to
/// [0, 1] leaves room for; values that it holds fast have no slope. `values` has the same size; take the
/// reference where there is one: a noisy pixel that came out too bright has a large variance and a small
/// slope by the same accident, which makes the estimate from the image itself too low (1 dB at 24 samples).
/// Nothing when the image has no variance.
std::optional<double> noise_mse_srgb8(const image::Image& image,
                                      const image::Image& values,
                                      const metrics::Mask& mask = {});

/// Why what the image says of its variance cannot be true: a channel is missing beside the others, or a
/// value is negative, infinite or none. "" when there is nothing to object, or nothing is said.
std::string variance_problem(const image::Image& image);

/// All other channels.
image::Image without_variances(const image::Image& image);

/// The PSNR that belongs to such an error; infinite for 0.
double psnr_srgb8_of(double mse);

}  // namespace orbs::runner
