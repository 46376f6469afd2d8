#include "image/colour.h"

#include "base/in_double.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace orbs::image {

float srgb_encode(float value) {
  if (value <= 0.0031308F) return 12.92F * value;
  return 1.055F * in_double::pow(value, 1.0F / 2.4F) - 0.055F;
}

float srgb_decode(float value) {
  if (value <= 0.04045F) return value / 12.92F;
  return in_double::pow((value + 0.055F) / 1.055F, 2.4F);
}

Image display_image(const Image& image) {
  constexpr std::array kMagenta{1.0F, 0.0F, 1.0F};
  Image shown = select_rgb(image, "");
  for (std::size_t i = 0; i < shown.pixels.size(); i += 3) {
    float* rgb = &shown.pixels[i];
    if (std::isnan(rgb[0]) || std::isnan(rgb[1]) || std::isnan(rgb[2])) {
      std::copy(kMagenta.begin(), kMagenta.end(), rgb);
      continue;
    }
    for (int c = 0; c < 3; ++c) rgb[c] = srgb_encode(std::clamp(rgb[c], 0.0F, 1.0F));
  }
  return shown;
}

}  // namespace orbs::image
