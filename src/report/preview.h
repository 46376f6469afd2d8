#pragma once

#include "image/image.h"

#include <string>

namespace orbs::report {

/// Longest side of a preview. A preview has at most 256^2 * 3 bytes, so that a page on a slow line paints
/// before the floats have arrived.
inline constexpr int kPreviewSide_px = 256;

/// The image as a display shows it, as a PNG of at most kPreviewSide_px on each side: each of its pixels is
/// the mean of f x f displayed pixels, with the smallest f that fits. At the right and lower edge the mean is
/// over the pixels that are there. NaN is magenta. InputError if the image has no R, G and B.
std::string preview_png(const image::Image& image);

}  // namespace orbs::report
