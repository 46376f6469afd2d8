#pragma once

#include "image/image.h"

namespace orbs::image {

/// The image of a renderer with a box filter at 1/divisor of the width and height: each pixel is the mean of
/// divisor x divisor pixels, in double. A channel "variance.*" becomes the variance of that mean, the sum of
/// the variances over divisor^4, because the noise of neighbouring pixels is independent. Attributes are
/// kept. InputError when width or height cannot be divided.
Image reduced_image(const Image& image, int divisor);

}  // namespace orbs::image
