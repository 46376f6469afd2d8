#include "judge/fault_images.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace orbs::judge {

namespace {

using image::Image;

// Offsets and weights of a filter along one axis.
struct Tap {
  int offset;
  float weight;
};

Image filtered_along(const Image& image, const std::vector<Tap>& taps, bool along_x) {
  Image out = image;
  const std::size_t channels = image.channel_count();
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < channels; ++c) {
        float sum = 0;
        for (const auto& [offset, weight] : taps) {
          const int u = along_x ? std::clamp(x + offset, 0, image.width - 1) : x;
          const int v = along_x ? y : std::clamp(y + offset, 0, image.height - 1);
          sum += weight * image.at(u, v, c);
        }
        out.at(x, y, c) = sum;
      }
  return out;
}

Image filtered(const Image& image, const std::vector<Tap>& taps) {
  return filtered_along(filtered_along(image, taps, true), taps, false);
}

// The taps that move an image by `by` px: the value at x - by.
std::vector<Tap> taps_of_move(double by_px, Between between) {
  const int whole = static_cast<int>(std::floor(-by_px));
  const auto t = static_cast<float>(-by_px - whole);
  if (t == 0) return {{whole, 1}};
  if (between == Between::Linear) return {{whole, 1 - t}, {whole + 1, t}};
  const float t2 = t * t;
  const float t3 = t2 * t;
  return {{whole - 1, (-t3 + 2 * t2 - t) / 2},
          {whole, (3 * t3 - 5 * t2 + 2) / 2},
          {whole + 1, (-3 * t3 + 4 * t2 + t) / 2},
          {whole + 2, (t3 - t2) / 2}};
}

}  // namespace

Image moved_by(const Image& image, double dx_px, double dy_px, Between between) {
  return filtered_along(filtered_along(image, taps_of_move(dx_px, between), true),
                        taps_of_move(dy_px, between), false);
}

Image rearranged(const Image& image, const std::function<std::array<int, 2>(int x, int y)>& from) {
  Image out = image;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const auto [u, v] = from(x, y);
      for (std::size_t c = 0; c < image.channel_count(); ++c) out.at(x, y, c) = image.at(u, v, c);
    }
  return out;
}

Image mapped(const Image& image, const std::function<float(float)>& map) {
  Image out = image;
  std::transform(image.pixels.begin(), image.pixels.end(), out.pixels.begin(), map);
  return out;
}

Image gaussian_blurred(const Image& image, double sigma_px) {
  const int reach = std::max(1, static_cast<int>(std::ceil(3 * sigma_px)));
  std::vector<Tap> taps;
  double sum = 0;
  for (int i = -reach; i <= reach; ++i) {
    const double weight = std::exp(-i * i / (2 * sigma_px * sigma_px));
    taps.push_back({i, static_cast<float>(weight)});
    sum += weight;
  }
  for (auto& tap : taps) tap.weight /= static_cast<float>(sum);
  return filtered(image, taps);
}

Image box_blurred(const Image& image, int side_px) {
  std::vector<Tap> taps;
  for (int i = -(side_px / 2); i <= side_px / 2; ++i) taps.push_back({i, 1.0F / static_cast<float>(side_px)});
  return filtered(image, taps);
}

Image in_squares(const Image& image, int side_px) {
  Image out = image;
  for (int y0 = 0; y0 < image.height; y0 += side_px)
    for (int x0 = 0; x0 < image.width; x0 += side_px) {
      const int x1 = std::min(x0 + side_px, image.width);
      const int y1 = std::min(y0 + side_px, image.height);
      for (std::size_t c = 0; c < image.channel_count(); ++c) {
        float sum = 0;
        for (int y = y0; y < y1; ++y)
          for (int x = x0; x < x1; ++x) sum += image.at(x, y, c);
        const float mean = sum / static_cast<float>((x1 - x0) * (y1 - y0));
        for (int y = y0; y < y1; ++y)
          for (int x = x0; x < x1; ++x) out.at(x, y, c) = mean;
      }
    }
  return out;
}

Image magnified(const Image& image, double factor) {
  Image out = image;
  const double centre_x = (image.width - 1) / 2.0;
  const double centre_y = (image.height - 1) / 2.0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double u = std::clamp(centre_x + (x - centre_x) / factor, 0.0, image.width - 1.0);
      const double v = std::clamp(centre_y + (y - centre_y) / factor, 0.0, image.height - 1.0);
      const int u0 = static_cast<int>(u);
      const int v0 = static_cast<int>(v);
      const int u1 = std::min(u0 + 1, image.width - 1);
      const int v1 = std::min(v0 + 1, image.height - 1);
      const auto s = static_cast<float>(u - u0);
      const auto t = static_cast<float>(v - v0);
      for (std::size_t c = 0; c < image.channel_count(); ++c)
        out.at(x, y, c) = (1 - t) * ((1 - s) * image.at(u0, v0, c) + s * image.at(u1, v0, c)) +
                          t * ((1 - s) * image.at(u0, v1, c) + s * image.at(u1, v1, c));
    }
  return out;
}

}  // namespace orbs::judge
