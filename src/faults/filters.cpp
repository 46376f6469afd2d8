#include "faults/filters.h"

#include "base/nth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <fmt/format.h>

namespace orbs::faults {

namespace {

using image::Image;

// The weights of a filter along one axis, whose middle is that of the pixel.
std::vector<float> weights_of(const Blur& blur) {
  const bool is_box = blur.filter == Blur::Filter::Box;
  const int reach = is_box ? static_cast<int>(blur.width_px) / 2
                           : std::max(1, static_cast<int>(std::ceil(3 * blur.width_px)));
  std::vector<float> weights;
  double sum = 0;
  for (int i = -reach; i <= reach; ++i) {
    const double weight = is_box ? 1 : std::exp(-i * i / (2 * blur.width_px * blur.width_px));
    weights.push_back(static_cast<float>(weight));
    sum += weight;
  }
  for (float& weight : weights) weight /= static_cast<float>(sum);
  return weights;
}

Image filtered_along(const Image& image, const std::vector<float>& weights, bool along_x) {
  Image out = image;
  const int reach = static_cast<int>(weights.size()) / 2;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < image.channel_count(); ++c) {
        float sum = 0;
        for (int i = 0; i <= 2 * reach; ++i) {
          const int u = along_x ? std::clamp(x + i - reach, 0, image.width - 1) : x;
          const int v = along_x ? y : std::clamp(y + i - reach, 0, image.height - 1);
          sum += nth(weights, i) * image.at(u, v, c);
        }
        out.at(x, y, c) = sum;
      }
  return out;
}

}  // namespace

Image Blur::apply(const Image& image) const {
  const auto weights = weights_of(*this);
  Image out = filtered_along(filtered_along(image, weights, true), weights, false);
  if (share == 1) return out;
  for (std::size_t i = 0; i < out.pixels.size(); ++i) {
    const auto sharp = static_cast<double>(image.pixels[i]);
    out.pixels[i] = static_cast<float>(sharp + share * (static_cast<double>(out.pixels[i]) - sharp));
  }
  return out;
}

std::string Blur::text() const {
  constexpr double kWidthOfHalf = 2.3548;  // full width at half maximum of a Gaussian of deviation 1
  return filter == Filter::Box ? fmt::format("blurred by a box filter of {:g} px", width_px)
                               : fmt::format("blurred by a filter of {:.2g} px", kWidthOfHalf * width_px);
}

Image Median::apply(const Image& image) const {
  Image out = image;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < image.channel_count(); ++c) {
        std::array<float, 9> values{};
        for (int i = 0; i < 9; ++i)
          values.at(static_cast<std::size_t>(i)) =
              image.at(std::clamp(x + i % 3 - 1, 0, image.width - 1),
                       std::clamp(y + i / 3 - 1, 0, image.height - 1), c);
        std::nth_element(values.begin(), values.begin() + 4, values.end());
        out.at(x, y, c) = values[4];
      }
  return out;
}

Image Resolution::apply(const Image& image) const {
  Image out = image;
  for (int y0 = 0; y0 < image.height; y0 += side_px)
    for (int x0 = 0; x0 < image.width; x0 += side_px) {
      const int x1 = std::min(x0 + side_px, image.width);
      const int y1 = std::min(y0 + side_px, image.height);
      const auto count = static_cast<float>((x1 - x0) * (y1 - y0));
      for (std::size_t c = 0; c < image.channel_count(); ++c) {
        float sum = 0;
        for (int y = y0; y < y1; ++y)
          for (int x = x0; x < x1; ++x) sum += image.at(x, y, c);
        const float mean = sum / (image::is_variance(image.channels[c]) ? count * count : count);
        for (int y = y0; y < y1; ++y)
          for (int x = x0; x < x1; ++x) out.at(x, y, c) = mean;
      }
    }
  return out;
}

std::string Resolution::text() const { return fmt::format("of 1/{} of the resolution", side_px); }

}  // namespace orbs::faults
