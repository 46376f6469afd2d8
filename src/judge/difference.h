#pragma once

#include "image/image.h"

namespace orbs::judge {

/// The image of - minus in R, G, B and, where both have variances, those of the difference: the sum of both,
/// or, where both images were made from the same samples, their difference, at least 0. The light of `minus`
/// is then a part of that of `of`, sample by sample, and what it scatters goes with it: for scene 248 the sum
/// is 110 times what is left, the difference 1.08 times (24 seeds, weighted as psnr_srgb8 weighs it;
/// covariances within a sample are left out). Same size and channels are the caller's promise. Attributes are
/// those of `of`.
image::Image difference_of(const image::Image& of, const image::Image& minus);

}  // namespace orbs::judge
