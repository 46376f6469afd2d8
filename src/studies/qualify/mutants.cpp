#include "studies/qualify/mutants.h"

#include "image/colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

using image::Image;

constexpr std::array<const char*, 3> kColours{"R", "G", "B"};

std::size_t colour_index(const Image& image, std::size_t colour) {
  return static_cast<std::size_t>(image::channel_index(image, kColours.at(colour)));
}

// -1 when the image does not know its noise.
int variance_index(const Image& image, std::size_t colour) {
  return image::channel_index(image, std::string("variance.") + kColours.at(colour));
}

// Calls change(value, variance) for each pixel and colour; without variance channels it gets a 0 that is
// discarded.
template <typename PixelChange>
Image changed(Image image, PixelChange change) {
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

Image black(const Image& image) {
  return changed(image, [](float& value, float& variance) { value = variance = 0; });
}

Image constant(const Image& image) {
  const auto mean = static_cast<float>(mean_radiance(image));
  return changed(image, [&](float& value, float& variance) {
    value = mean;
    variance = 0;
  });
}

Image with_nan(Image image) {
  image.at(image.width / 2, image.height / 2, colour_index(image, 1)) =
      std::numeric_limits<float>::quiet_NaN();
  return image;
}

Image shifted(const Image& image) {
  Image out = image;
  for (int y = 0; y < image.height; ++y)
    for (int x = 1; x < image.width; ++x)
      for (std::size_t c = 0; c < image.channel_count(); ++c) out.at(x, y, c) = image.at(x - 1, y, c);
  return out;
}

Image with_swapped(Image image, std::size_t a, std::size_t b) {
  const auto swap_channels = [&](std::size_t one, std::size_t other) {
    for (std::size_t i = 0; i < image.pixels.size(); i += image.channel_count())
      std::swap(image.pixels[i + one], image.pixels[i + other]);
  };
  swap_channels(colour_index(image, a), colour_index(image, b));
  if (variance_index(image, a) >= 0 && variance_index(image, b) >= 0)
    swap_channels(static_cast<std::size_t>(variance_index(image, a)),
                  static_cast<std::size_t>(variance_index(image, b)));
  return image;
}

std::pair<std::size_t, std::size_t> most_different_colours(const Image& image) {
  std::pair<std::size_t, std::size_t> most{0, 1};
  double largest = -1;
  for (const auto& [a, b] : {std::pair<std::size_t, std::size_t>{0, 1}, {0, 2}, {1, 2}}) {
    double sum = 0;
    for (std::size_t i = 0; i < image.pixels.size(); i += image.channel_count()) {
      const double d = static_cast<double>(image.pixels[i + colour_index(image, a)]) -
                       static_cast<double>(image.pixels[i + colour_index(image, b)]);
      sum += d * d;
    }
    if (sum <= largest) continue;
    largest = sum;
    most = {a, b};
  }
  return most;
}

Image encoded_once_more(const Image& image) {
  return changed(image, [](float& value, float& variance) {
    constexpr float kStep =
        1e-3F;  // the slope as a quotient: the curve has a kink, and no variance needs more
    const float slope = (image::srgb_encode(value + kStep) - image::srgb_encode(value - kStep)) / (2 * kStep);
    value = image::srgb_encode(value);
    variance *= slope * slope;
  });
}

// Mean of the 2 x 2 pixels, those that there are at an odd edge; the variance of a mean of n is sum / n^2.
Image at_half_resolution(const Image& image) {
  Image out = image;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < image.channel_count(); ++c) {
        const int x0 = x - x % 2;
        const int y0 = y - y % 2;
        const int x1 = std::min(x0 + 2, image.width);
        const int y1 = std::min(y0 + 2, image.height);
        float sum = 0;
        for (int v = y0; v < y1; ++v)
          for (int u = x0; u < x1; ++u) sum += image.at(u, v, c);
        const auto count = static_cast<float>((x1 - x0) * (y1 - y0));
        out.at(x, y, c) = sum / (image::is_variance(image.channels[c]) ? count * count : count);
      }
  return out;
}

Image clamped(const Image& image) {
  return changed(image, [](float& value, float& variance) {
    if (value <= 1) return;
    value = 1;
    variance = 0;
  });
}

// Of the squares without masked pixels that lie 4 px off a grid of their side.
Rectangle place_of_median(const Image& reference, const std::vector<std::uint8_t>& included, int side_px) {
  constexpr int kOff_px = 4;
  std::vector<std::pair<double, Rectangle>> places;
  for (int y = kOff_px; y + side_px <= reference.height; y += side_px)
    for (int x = kOff_px; x + side_px <= reference.width; x += side_px) {
      double sum = 0;
      bool is_whole = true;
      for (int v = y; v < y + side_px; ++v)
        for (int u = x; u < x + side_px; ++u) {
          is_whole =
              is_whole && included[static_cast<std::size_t>(v) * static_cast<std::size_t>(reference.width) +
                                   static_cast<std::size_t>(u)] != 0;
          sum += image::luminance(static_cast<double>(reference.at(u, v, colour_index(reference, 0))),
                                  static_cast<double>(reference.at(u, v, colour_index(reference, 1))),
                                  static_cast<double>(reference.at(u, v, colour_index(reference, 2))));
        }
      if (is_whole) places.push_back({sum, {x, y, x + side_px, y + side_px}});
    }
  if (places.empty()) return {0, 0, std::min(side_px, reference.width), std::min(side_px, reference.height)};
  const auto middle = places.begin() + static_cast<std::ptrdiff_t>(places.size() / 2);
  std::nth_element(places.begin(), middle, places.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  return middle->second;
}

}  // namespace

std::vector<Fault> faults_of(const Image& reference) {
  const auto [a, b] = most_different_colours(reference);
  return {{"black", black},
          {"constant", constant},
          {"one NaN", with_nan},
          {"shifted by 1 px", shifted},
          {"+2 % light", [](const Image& image) { return with_more_light(image, 0.02); }},
          {"-2 % light", [](const Image& image) { return with_more_light(image, -0.02); }},
          {fmt::format("{} and {} swapped", kColours.at(a), kColours.at(b)),
           [a = a, b = b](const Image& image) { return with_swapped(image, a, b); }},
          {"sRGB twice", encoded_once_more},
          {"half resolution", at_half_resolution},
          {"clamped at 1", clamped}};
}

Image with_more_light(const Image& image, double share) {
  const auto factor = static_cast<float>(1 + share);
  return changed(image, [&](float& value, float& variance) {
    value *= factor;
    variance *= factor * factor;
  });
}

Image with_leak(const Image& image, const Rectangle& where, double radiance) {
  Image out = image;
  for (int y = where.y0; y < where.y1; ++y)
    for (int x = where.x0; x < where.x1; ++x)
      for (std::size_t colour = 0; colour < 3; ++colour)
        out.at(x, y, colour_index(out, colour)) += static_cast<float>(radiance);
  return out;
}

Rectangle place_of_leak(const Image& reference, const metrics::Mask& mask) {
  constexpr int kSide_px = 16;
  return place_of_median(reference, metrics::included_pixels(mask, reference.width, reference.height),
                         kSide_px);
}

Rectangle place_of_patch(const Image& reference, int side_px) {
  return place_of_median(reference, metrics::included_pixels({}, reference.width, reference.height), side_px);
}

double mean_radiance(const Image& image) {
  double sum = 0;
  for (const float value : image::select_rgb(image, "").pixels) sum += static_cast<double>(value);
  return sum / (3 * static_cast<double>(image.pixel_count()));
}

}  // namespace orbs::studies
