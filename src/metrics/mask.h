#pragma once

#include "base/rectangle.h"

#include <cstdint>
#include <vector>

namespace orbs::metrics {

/// Pixels that no number counts: those in any rectangle and those whose byte is not 0. Empty: every pixel
/// counts.
struct Mask {
  std::vector<Rectangle> rectangles;
  std::vector<std::uint8_t> pixels;  // empty, or one byte for each pixel, row by row from the top
};

/// One byte for each pixel of a width x height image: 1 counted, 0 left out. InputError when a rectangle is
/// empty or reaches beyond the image, when the bytes are not as many as the pixels, or when no pixel is
/// left.
std::vector<std::uint8_t> included_pixels(const Mask& mask, int width, int height);

}  // namespace orbs::metrics
