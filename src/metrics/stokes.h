#pragma once

#include "image/image.h"
#include "metrics/mask.h"

#include <array>
#include <optional>

namespace orbs::metrics {

/// Layers of polarised light that an image may hold beside its colour.
inline constexpr std::array kStokesLayers{"S1.", "S2.", "S3."};

bool has_stokes(const image::Image& image);

/// Root mean square, over S1 to S3 and the blocks of 8 x 8 px, of the difference of the block means in
/// Rec.709 luminance, over the reference's mean luminance. Block means, because single pixels are mostly
/// noise: half of unpolarised light is in each of these differences. Nothing where one of the images has no
/// such layers or the reference is black. Masked pixels do not count; InputError when the mask does not fit.
std::optional<double> stokes_error(const image::Image& result,
                                   const image::Image& reference,
                                   const Mask& mask = {});

}  // namespace orbs::metrics
