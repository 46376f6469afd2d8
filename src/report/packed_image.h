#pragma once

#include "image/image.h"

#include <string>
#include <string_view>
#include <vector>

/// Images in the form that the page reads (format "orbs-image/2"), so that no browser has to decode EXR.

namespace orbs::report {

/// One gzip member (RFC 1952) without name and time: equal bytes give equal files. `level` is zlib's, 1
/// (fast) to 9 (small).
std::string gzip(std::string_view bytes, int level);

/// Base64 of RFC 4648, section 4, on one line.
std::string base64(std::string_view bytes);

/// Exact: every number arrives as it stands in the image. Rounded: as half floats, 11 significant bits;
/// channels with a finite value beyond the largest half stay exact.
enum class Rounding { Exact, Rounded };

/// Fast: for a server that waits for no line. Small: for a file, ten times as slow.
enum class Packing { Fast, Small };

/// The parts before the last '.' of the channel names, each once, in the order of the channels: "" for R, G,
/// B, "variance" for "variance.R".
std::vector<std::string> layers_of(const image::Image& image);

/// One layer as gzip of: the length of the header in 4 bytes, little-endian; the header, JSON, filled up with
/// blanks so that what follows starts at a multiple of 8; for each channel its pixels by rows from the top,
/// little-endian half or float as the header says. Exact channels are half where every value survives that.
/// A small one is "separated": of a channel the highest bytes of all pixels come first, then the next lower
/// ones and so on, and each byte is stored less the one before it (modulo 256). The header holds width,
/// height, separated, layer, layers (all there are), channels (name, type, exact) and the image's text
/// attributes. InputError when there is no such layer.
std::string packed_image(const image::Image& image,
                         std::string_view layer,
                         Rounding rounding,
                         Packing packing);

/// Longest side of a preview. A preview has at most 256^2 * 3 bytes, so that a page on a slow line paints
/// before the floats have arrived.
inline constexpr int kPreviewSide_px = 256;

/// The image as a display shows it, as a PNG of at most kPreviewSide_px on each side: each of its pixels is
/// the mean of f x f displayed pixels, with the smallest f that fits. At the right and lower edge the mean is
/// over the pixels that are there. NaN is magenta. InputError if the image has no R, G and B.
std::string preview_png(const image::Image& image);

}  // namespace orbs::report
