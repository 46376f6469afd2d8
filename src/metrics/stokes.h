#pragma once

#include "image/image.h"
#include "metrics/mask.h"
#include "metrics/metric.h"

#include <array>
#include <optional>

namespace orbs::metrics {

/// Layers of polarised light that a picture may hold beside its colour.
inline constexpr std::array kStokesLayers{"S1.", "S2.", "S3."};

bool has_stokes(const image::Image& picture);

/// Root mean square, over S1 to S3 and the blocks of 8 x 8 px, of the difference of the block means in
/// Rec.709 luminance, over the reference's mean luminance. Block means, because single pixels are mostly
/// noise: half of unpolarised light is in each of these differences. Nothing where one of the pictures has no
/// such layers or the reference is black. Masked pixels do not count; InputError when the mask does not fit.
std::optional<double> stokes_error(const image::Image& result,
                                   const image::Image& reference,
                                   const Mask& mask = {});

/// How the layers are shown, beside the error maps: as they are.
inline constexpr std::array kStokesMaps{
    MapInfo{"S1", "Stokes parameter S1 of the result, above 0: level; linear Rec.709", true, 0.25F},
    MapInfo{"S2", "Stokes parameter S2 of the result, above 0: +45 degrees, up and to the right", true,
            0.25F},
    MapInfo{"S3", "Stokes parameter S3 of the result, above 0: right-circular", true, 0.25F}};

}  // namespace orbs::metrics
