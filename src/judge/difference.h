#pragma once

#include "image/image.h"
#include "metrics/compare.h"
#include "results/record.h"

#include <filesystem>
#include <vector>

namespace orbs::judge {

/// The image of - minus in R, G, B and, where both have variances, those of the difference: the sum of both,
/// or, where both images were made from the same samples, their difference, at least 0. The light of `minus`
/// is then a part of that of `of`, sample by sample, and what it scatters goes with it: for scene 248 the sum
/// is 110 times what is left, the difference 1.08 times (24 seeds, weighted as psnr_srgb8 weighs it;
/// covariances within a sample are left out). Same size and channels are the caller's promise. Attributes are
/// those of `of`.
image::Image difference_of(const image::Image& of, const image::Image& minus);

/// Writes result.png and the error maps as error-<name>.exr and .png (with a colour scale) into `folder`.
/// Returns the maps; their files are relative to `folder`.
std::vector<results::MapRecord> write_maps(const image::Image& result,
                                           const metrics::Comparison& comparison,
                                           const std::filesystem::path& folder);

}  // namespace orbs::judge
