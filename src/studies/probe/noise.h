#pragma once

#include "image/image.h"
#include "studies/probe/primary_visibility.h"

#include <string_view>
#include <vector>

namespace orbs::studies {

/// How far these channels ("RGB") of a pixel may lie from what they should be because of noise: eight times
/// the median standard deviation at these pixels, of the noisiest channel. The median, since a few pixels at
/// edges that are out of place are no noise; eight, since two seeds underestimate it 1.5-fold, and a bright
/// pixel may be twice as noisy as most. 0 for an image without variances.
double noise_tolerance(const image::Image& image,
                       const std::vector<Pixel>& pixels,
                       std::string_view channels);

}  // namespace orbs::studies
