#include "faults/geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include <fmt/format.h>

namespace orbs::faults {

namespace {

using image::Image;

// The pixels along one axis that a value between them is made of.
struct Taps {
  int first = 0;
  std::size_t count = 1;
  std::array<float, 4> weights{1};
};

Taps taps_at(double place, Between between) {
  if (between == Between::Nearest) return {static_cast<int>(std::lround(place))};
  const int whole = static_cast<int>(std::floor(place));
  const auto t = static_cast<float>(place - whole);
  if (t == 0) return {whole};
  if (between == Between::Linear) return {whole, 2, {1 - t, t}};
  const float t2 = t * t;
  const float t3 = t2 * t;
  return {whole - 1,
          4,
          {(-t3 + 2 * t2 - t) / 2, (3 * t3 - 5 * t2 + 2) / 2, (-3 * t3 + 4 * t2 + t) / 2, (t3 - t2) / 2}};
}

float value_of(const Image& image, const Taps& across, const Taps& down, std::size_t channel) {
  float sum = 0;
  for (std::size_t j = 0; j < down.count; ++j) {
    const int y = std::clamp(down.first + static_cast<int>(j), 0, image.height - 1);
    float row = 0;
    for (std::size_t i = 0; i < across.count; ++i)
      row += across.weights.at(i) *
             image.at(std::clamp(across.first + static_cast<int>(i), 0, image.width - 1), y, channel);
    sum += down.weights.at(j) * row;
  }
  return sum;
}

// The value of each pixel is that at source(x, y) in the image.
template <typename Source>
Image resampled(const Image& image, Between between, Source source) {
  Image out = image;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const std::pair<double, double> at = source(x, y);
      const auto across = taps_at(std::clamp(at.first, 0.0, image.width - 1.0), between);
      const auto down = taps_at(std::clamp(at.second, 0.0, image.height - 1.0), between);
      for (std::size_t c = 0; c < image.channel_count(); ++c)
        out.at(x, y, c) = value_of(image, across, down, c);
    }
  return out;
}

}  // namespace

Image Shift::apply(const Image& image) const {
  return resampled(image, between, [this](int x, int y) { return std::pair(x - dx_px, y - dy_px); });
}

std::string Shift::text() const { return fmt::format("shifted by ({}, {}) px", dx_px, dy_px); }

Image Turn::apply(const Image& image) const {
  return resampled(image, Between::Nearest, [&](int x, int y) {
    if (exchanges) std::swap(x, y);
    return std::pair<double, double>(mirrors_x ? image.width - 1 - x : x,
                                     mirrors_y ? image.height - 1 - y : y);
  });
}

std::string Turn::text() const {
  if (!exchanges)
    return !mirrors_y ? "mirrored left to right" : mirrors_x ? "turned by 180 degrees" : "upside down";
  if (mirrors_x == mirrors_y)
    return mirrors_x ? "transposed and turned by 180 degrees" : "transposed (x and y exchanged)";
  return mirrors_y ? "turned by 90 degrees to the right" : "turned by 90 degrees to the left";
}

Image Magnification::apply(const Image& image) const {
  const double centre_x = (image.width - 1) / 2.0;
  const double centre_y = (image.height - 1) / 2.0;
  return resampled(image, between, [&](int x, int y) {
    return std::pair(centre_x + (x - centre_x) / by, centre_y + (y - centre_y) / by);
  });
}

std::string Magnification::text() const { return fmt::format("magnified by {:.3g} about its centre", by); }

Image Rotation::apply(const Image& image) const {
  const double angle = degrees * std::numbers::pi / 180;
  return resampled(image, Between::Linear, [&](int x, int y) {
    return std::pair(x + angle * (y + 0.5 - image.height / 2.0), y - angle * (x + 0.5 - image.width / 2.0));
  });
}

Image Crop::apply(const Image& image) const {
  Image out = image;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (x < kept.x0 || x >= kept.x1 || y < kept.y0 || y >= kept.y1)
        for (std::size_t c = 0; c < image.channel_count(); ++c) out.at(x, y, c) = 0;
  return out;
}

std::string Crop::text() const {
  return fmt::format("cropped to the pixels {}, black beside them", rectangle_text(kept));
}

}  // namespace orbs::faults
