#include "faults/shading.h"

#include "faults/pixels.h"
#include "image/colour.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace orbs::faults {

namespace {

using image::Image;

// factor(x, y) of the light of each pixel.
template <typename FactorAt>
Image shaded(const Image& image, FactorAt factor_at) {
  Image out = image;
  for (std::size_t colour = 0; colour < 3; ++colour) {
    const auto value = colour_index(image, colour);
    const int variance = variance_index(image, colour);
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        const double factor = factor_at(x, y);
        out.at(x, y, value) = static_cast<float>(factor * static_cast<double>(image.at(x, y, value)));
        if (variance >= 0)
          out.at(x, y, static_cast<std::size_t>(variance)) *= static_cast<float>(factor * factor);
      }
  }
  return out;
}

// From -1 to 1 over `size` pixels.
double from_centre(int at, int size) { return (2 * at + 1.0) / size - 1; }

double luminance_at(const Image& image, int x, int y) {
  return image::luminance(static_cast<double>(image.at(x, y, colour_index(image, 0))),
                          static_cast<double>(image.at(x, y, colour_index(image, 1))),
                          static_cast<double>(image.at(x, y, colour_index(image, 2))));
}

bool is_within(const Rectangle& where, int x, int y) {
  return x >= where.x0 && x < where.x1 && y >= where.y0 && y < where.y1;
}

}  // namespace

Image Gradient::apply(const Image& image) const {
  return shaded(image, [&](int at_x, int at_y) {
    return 1 + x * from_centre(at_x, image.width) + y * from_centre(at_y, image.height);
  });
}

Image Vignette::apply(const Image& image) const {
  return shaded(image, [&](int at_x, int at_y) {
    const double x = from_centre(at_x, image.width);
    const double y = from_centre(at_y, image.height);
    return 1 - share / 2 * (x * x + y * y);
  });
}

Image Pattern::apply(const Image& image) const {
  return shaded(image, [this](int x, int y) {
    const int column = width_px == 0 ? 0 : x / width_px;
    const int row = height_px == 0 ? 0 : y / height_px;
    return (column + row) % 2 == 0 ? 1 + share : 1 - share;
  });
}

Image Patch::apply(const Image& image) const {
  return shaded(image, [this](int x, int y) { return is_within(where, x, y) ? factor : 1; });
}

Image Brightness::apply(const Image& image) const {
  const double mean = mean_radiance(*reference);
  return shaded(image, [&](int x, int y) {
    const double brightness = luminance_at(*reference, x, y) / mean;
    return brightness > above && brightness < below ? factor : 1;
  });
}

Image Leak::apply(const Image& image) const {
  Image out = image;
  for (int y = where.y0; y < where.y1; ++y)
    for (int x = where.x0; x < where.x1; ++x)
      for (std::size_t colour = 0; colour < 3; ++colour)
        out.at(x, y, colour_index(out, colour)) += static_cast<float>(radiance);
  return out;
}

Rectangle middle_patch(const Image& reference, int side_px, const std::vector<std::uint8_t>& included) {
  constexpr int kOff_px = 4;
  std::vector<std::pair<double, Rectangle>> places;
  for (int y = kOff_px; y + side_px <= reference.height; y += side_px)
    for (int x = kOff_px; x + side_px <= reference.width; x += side_px) {
      double sum = 0;
      bool is_whole = true;
      for (int v = y; v < y + side_px; ++v)
        for (int u = x; u < x + side_px; ++u) {
          const auto pixel = static_cast<std::size_t>(v) * static_cast<std::size_t>(reference.width) +
                             static_cast<std::size_t>(u);
          is_whole = is_whole && (included.empty() || included[pixel] != 0);
          sum += luminance_at(reference, u, v);
        }
      if (is_whole) places.push_back({sum, {x, y, x + side_px, y + side_px}});
    }
  if (places.empty()) return {0, 0, std::min(side_px, reference.width), std::min(side_px, reference.height)};
  const auto middle = places.begin() + static_cast<std::ptrdiff_t>(places.size() / 2);
  std::nth_element(places.begin(), middle, places.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  return middle->second;
}

Leak leak_of_mean_light(const Image& reference, const std::vector<std::uint8_t>& included) {
  constexpr int kSide_px = 16;
  return {middle_patch(reference, kSide_px, included), mean_radiance(reference)};
}

}  // namespace orbs::faults
