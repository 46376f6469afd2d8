#pragma once

#include "image/colour.h"
#include "image/image.h"

#include <functional>
#include <string>
#include <vector>

namespace orbs::metrics_test {

/// An image with channels R, G, B, all three of value(x, y).
inline image::Image grey_image(int width, int height, const std::function<float(int, int)>& value) {
  image::Image image = image::make_image(width, height, {"R", "G", "B"});
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (std::size_t c = 0; c < 3; ++c) image.at(x, y, c) = value(x, y);
  return image;
}

inline image::Image constant_image(int width, int height, float value) {
  return grey_image(width, height, [value](int, int) { return value; });
}

/// An image that has this grey on the display, i.e. after the sRGB encoding.
inline image::Image displayed_grey(int width, int height, float display_value) {
  return constant_image(width, height, image::srgb_decode(display_value));
}

/// Detail without a period that the 11 px window could fall in with; values in [0.05, 0.95].
inline float detail(int x, int y) {
  return 0.05F + 0.9F * static_cast<float>((x * x * 7 + y * 13 + x * y * 3) % 97) / 96.0F;
}

}  // namespace orbs::metrics_test
