#pragma once

#include "image/image.h"

#include <string_view>
#include <vector>

namespace orbs::studies {

/// The noise of one image, estimated from several with different seeds and nothing else. No reference is
/// needed, and every renderer is measured alike; what it does not see is an error that all seeds share.
struct SeedNoise {
  double relative_mse = 0;
  double psnr_srgb8_db = 0;
};

inline constexpr std::string_view kRelativeMseDefinition =
    "mean over the channels R, G, B of all pixels of s^2 / (m^2 + 0.01); s^2: unbiased variance over "
    "seeds of the linear Rec.709 value; m: mean of the images of all renderers and seeds";
inline constexpr std::string_view kSeedPsnrDefinition =
    "10 log10(255^2 / (MSE / 2)); MSE: that of psnr_srgb8 between images of two seeds, of which each has "
    "half, mean over successive seeds";

/// At least two images of the same samples; `mean` gives the denominators and has their size.
SeedNoise noise_of_seeds(const std::vector<image::Image>& images, const image::Image& mean, int threads);

}  // namespace orbs::studies
