#pragma once

#include "image/image.h"

#include <string_view>
#include <vector>

namespace orbs::studies {

/// The noise of one image, estimated only from several images with different seeds. It needs no reference and
/// measures every renderer alike; it cannot show an error that all seeds share.
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

/// From at least two images of the same sample count; `mean`, of their size, gives the denominators.
SeedNoise noise_of_seeds(const std::vector<image::Image>& images, const image::Image& mean, int threads);

}  // namespace orbs::studies
