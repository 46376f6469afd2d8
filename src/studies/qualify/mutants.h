#pragma once

#include "image/image.h"
#include "metrics/mask.h"

#include <functional>
#include <string>
#include <vector>

/// Mutants: what a control image would have been had its renderer made one of the usual mistakes. Each has
/// the noise of the control image and states it in its variance, as the mistaken renderer would.
namespace orbs::studies {

/// A mistake as a change of a linear image with R, G, B and, where it has them, their variances.
using Change = std::function<image::Image(const image::Image&)>;

struct Fault {
  std::string name;
  Change apply;
};

/// The faults that need no other render, each with its name:
/// black; constant (the mean of the image all over); one NaN pixel in the middle; all shifted to the right
/// by 1 px (the left column stays); 2 % more and 2 % less light; two channels swapped, those two that differ
/// most in `reference`; the sRGB curve applied once too often; half the resolution, scaled up again; values
/// clamped to 1.
std::vector<Fault> faults_of(const image::Image& reference);

/// `share` of the light too much, everywhere.
image::Image with_more_light(const image::Image& image, double share);

/// `radiance` added to R, G, B of these pixels.
image::Image with_leak(const image::Image& image, const Rectangle& where, double radiance);

/// Where a light leak is put: the 16 x 16 px whose mean luminance is the median of all such places without
/// masked pixels, 4 px off any grid of 8 or 16 px. The whole image when it is smaller than that.
Rectangle place_of_leak(const image::Image& reference, const metrics::Mask& mask);

/// As above without a mask, of side `side_px`, cut to the image.
Rectangle place_of_patch(const image::Image& reference, int side_px);

/// Mean of R, G and B over all pixels.
double mean_radiance(const image::Image& image);

}  // namespace orbs::studies
