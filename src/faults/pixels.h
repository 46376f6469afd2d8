#pragma once

#include "image/image.h"

#include <array>
#include <cstddef>
#include <string>

/// What the kinds of faults do with the pixels of an image.
namespace orbs::faults {

constexpr std::array<const char*, 3> kColours{"R", "G", "B"};

inline std::size_t colour_index(const image::Image& image, std::size_t colour) {
  return static_cast<std::size_t>(image::channel_index(image, kColours.at(colour)));
}

/// -1 when the image does not know its noise.
inline int variance_index(const image::Image& image, std::size_t colour) {
  return image::channel_index(image, std::string("variance.") + kColours.at(colour));
}

/// Calls change(value, its variance) for R, G and B of each pixel. Without variances it gets a 0 that is
/// discarded.
template <typename Change>
image::Image with_each_value(image::Image image, Change change) {
  for (std::size_t colour = 0; colour < 3; ++colour) {
    const auto value = colour_index(image, colour);
    const int variance = variance_index(image, colour);
    for (std::size_t i = 0; i < image.pixels.size(); i += image.channel_count()) {
      float nothing = 0;
      change(image.pixels[i + value],
             variance < 0 ? nothing : image.pixels[i + static_cast<std::size_t>(variance)]);
    }
  }
  return image;
}

/// Mean of R, G and B over all pixels.
inline double mean_radiance(const image::Image& image) {
  double sum = 0;
  for (const float value : image::select_rgb(image, "").pixels) sum += static_cast<double>(value);
  return sum / (3 * static_cast<double>(image.pixel_count()));
}

}  // namespace orbs::faults
