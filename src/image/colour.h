#pragma once

#include "image/image.h"

namespace orbs::image {

/// Display value of linear `value` by the sRGB curve as ORB.S states it; meant for [0, 1], beyond which the
/// curve simply goes on (below 0 linearly). The clamp that ORB.S puts before it is the caller's step.
float srgb_encode(float value);

/// Linear value of the display value `value`: the inverse of srgb_encode in ORB.S's form.
float srgb_decode(float value);

/// Relative luminance of linear Rec.709 (ITU-R BT.709 weights .2126 .7152 .0722). On encoded values the same
/// sum is the luma that SSIM compares.
constexpr double luminance(double r, double g, double b) { return 0.2126 * r + 0.7152 * g + 0.0722 * b; }

/// The channels R, G, B as they appear on a screen: clamped to [0, 1], then sRGB-encoded. Pixels with NaN are
/// drawn magenta, so that an image with bad numbers can be looked at. InputError when a channel is missing.
Image display_image(const Image& image);

}  // namespace orbs::image
