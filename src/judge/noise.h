#pragma once

#include "image/image.h"
#include "metrics/image_pair.h"
#include "metrics/pair_samples.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace orbs::judge {

/// The mean squared error that noise alone is expected to cause in psnr_srgb8 (in steps of 1/255, squared):
/// `variances` of the mean go through the slope of the sRGB curve at `values` (delta method), up to the
/// largest error that the clamp to [0, 1] leaves room for; values beyond the clamp have no slope. Both are
/// interleaved R, G, B; pixels whose `included` is 0 do not count. Nothing when there are no variances.
///
/// `values` should be those of the reference where there is one: a noisy pixel that came out too bright has a
/// large variance and a small slope by the same accident, which makes the estimate from the image itself too
/// low (1 dB at 24 samples).
std::optional<double> noise_mse_srgb8(const std::vector<float>& variances,
                                      const std::vector<float>& values,
                                      const std::vector<std::uint8_t>& included);

/// As above, from the channels "variance.R/G/B" of `image` and the colours of `values`; every pixel counts.
std::optional<double> noise_mse_srgb8(const image::Image& image, const image::Image& values);

/// The same of result and reference together where the result does not state its noise: from the steps of
/// their difference between pixels 4 px apart, beyond the reach of a pixel's filter, both of which are
/// `chosen` (1); without the largest steps of each block, which are put back as of normally distributed
/// noise, so that single wrong pixels do not pass for it. Nothing when less than a tenth of the pixels is
/// left.
std::optional<double> scatter_mse_srgb8(const metrics::ImagePair& pair,
                                        const std::vector<std::uint8_t>& chosen);

/// Why the variances in an image cannot be true: a channel is missing beside the others, a value is negative,
/// infinite or NaN, or the image is so dim that its variances are zero as floats, whatever its noise. "" when
/// they can be, or there are none.
std::string variance_problem(const image::Image& image);

/// The image with all channels but its variances.
image::Image without_variances(const image::Image& image);

/// The PSNR in dB that belongs to such an error; infinite for 0.
double psnr_srgb8_of(double mse);

/// The mean squared error that belongs to a PSNR in dB.
double mse_srgb8_of(double psnr_db);

}  // namespace orbs::judge
