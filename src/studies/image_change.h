#pragma once

#include "image/image.h"
#include "studies/effect_cost.h"

#include <vector>

namespace orbs::studies {

/// Renders of the same scene one way and the other, in pairs of the same seed; at least two pairs of one
/// size.
ImageChange change_between(const std::vector<image::Image>& usual, const std::vector<image::Image>& other);

/// Mean over the channels and pixels of the variance of the mean that the images carry; mean of all
/// images.
double mean_variance(const std::vector<image::Image>& images);

}  // namespace orbs::studies
