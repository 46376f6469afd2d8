#pragma once

#include "image/image.h"

#include <array>
#include <cstddef>
#include <string>

namespace orbs::metrics {

enum class Alignment { Comparable, WrongSize, WrongChannels, InvalidPixels };

/// Radiance is never negative, so a negative value is a fault. Images made by subtraction are negative by
/// noise.
enum class NegativePixels { Refused, Allowed };

/// Bad pixels of one image in R, G, B; a pixel counts once in each kind that one of its channels shows.
struct PixelFaults {
  std::size_t nan = 0;
  std::size_t infinite = 0;
  std::size_t negative = 0;
  std::array<int, 4> box{};  // [x0, y0, x1, y1) around the faulty ones
  std::string first;         // "(12, 7), channel G, value nan", first by rows; empty when there are none
};

/// Counts the bad pixels of an image that has the channels R, G, B. Masked pixels are counted too: a bad
/// number is a fault of the renderer wherever it is.
PixelFaults count_faults(const image::Image& image, NegativePixels negatives);

/// The answer to "can these two be compared at all", asked once before any metric.
struct AlignmentReport {
  Alignment alignment = Alignment::Comparable;
  std::string reason;  // why, for a reader; also says that all is well
  PixelFaults result;  // counted when size and channels fit
  PixelFaults reference;
};

/// Same size, channels R, G, B in both, no NaN, infinite or (unless allowed) negative value in them,
/// masked pixels included.
AlignmentReport check_alignment(const image::Image& result,
                                const image::Image& reference,
                                NegativePixels negatives = NegativePixels::Refused);

}  // namespace orbs::metrics
