#include "image/image.h"

#include "base/error.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::image {

Image make_image(int width, int height, std::vector<std::string> channels) {
  assert(width > 0 && height > 0 && !channels.empty());
  Image image{width, height, std::move(channels), {}, {}};
  image.pixels.assign(image.pixel_count() * image.channel_count(), 0.0F);
  return image;
}

int channel_index(const Image& image, std::string_view name) {
  const auto found = std::find(image.channels.begin(), image.channels.end(), name);
  return found == image.channels.end() ? -1 : static_cast<int>(found - image.channels.begin());
}

Image select_rgb(const Image& image, std::string_view prefix) {
  return select_channels(
      image, {fmt::format("{}R", prefix), fmt::format("{}G", prefix), fmt::format("{}B", prefix)});
}

Image select_channels(const Image& image, const std::array<std::string, 3>& channels) {
  std::array<std::size_t, 3> source{};
  for (std::size_t c = 0; c < 3; ++c) {
    const int index = channel_index(image, channels[c]);
    if (index < 0)
      throw InputError(fmt::format("the image has no channel '{}'; it has {}", channels[c],
                                   fmt::join(image.channels, ", ")));
    source[c] = static_cast<std::size_t>(index);
  }
  Image rgb = make_image(image.width, image.height, {"R", "G", "B"});
  for (std::size_t pixel = 0; pixel < image.pixel_count(); ++pixel)
    for (std::size_t c = 0; c < 3; ++c)
      rgb.pixels[3 * pixel + c] = image.pixels[pixel * image.channel_count() + source[c]];
  return rgb;
}

std::vector<Image> colours_of(const std::vector<Image>& images) {
  std::vector<Image> colours;
  colours.reserve(images.size());
  for (const Image& image : images) colours.push_back(select_rgb(image, ""));
  return colours;
}

bool has_same_colours(const Image& a, const Image& b) {
  return a.width == b.width && a.height == b.height && select_rgb(a, "").pixels == select_rgb(b, "").pixels;
}

namespace {

// Of the pixels of one that is made of several: what combination_of says.
struct Combined {
  double sum = 0;
  double weight = 0;
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
  double first = 0;
};

double value_of(const Combined& pixels, Combination combination, double count) {
  switch (combination) {
    case Combination::Mean:
      return pixels.sum * (1 / count);
    case Combination::VarianceOfMean:
      return pixels.sum * (1 / (count * count));
    case Combination::CoveredMean:
      return pixels.weight > 0 ? pixels.sum / pixels.weight : 0;
    case Combination::Least:
      return pixels.weight > 0 ? pixels.least : 0;
    case Combination::Most:
      return pixels.weight > 0 ? pixels.most : 0;
    case Combination::First:
      return pixels.first;
  }
  return 0;
}

// The pixel beside the middle of `divisor` x `divisor` pixels is the one that tells what is there.
Combined combined_pixels(const Image& image, int x, int y, int divisor, std::size_t channel) {
  const auto combination = combination_of(image.channels[channel]);
  const bool by_coverage = combination != Combination::Mean && combination != Combination::VarianceOfMean;
  const int coverage = by_coverage ? channel_index(image, "coverage.A") : -1;
  Combined out;
  out.first = static_cast<double>(image.at(x * divisor + divisor / 2, y * divisor + divisor / 2, channel));
  for (int v = y * divisor; v < (y + 1) * divisor; ++v)
    for (int u = x * divisor; u < (x + 1) * divisor; ++u) {
      const double weight =
          coverage < 0 ? 1 : static_cast<double>(image.at(u, v, static_cast<std::size_t>(coverage)));
      if (weight == 0) continue;
      const double value = static_cast<double>(image.at(u, v, channel));
      out.sum += weight * value;
      out.weight += weight;
      out.least = std::min(out.least, value);
      out.most = std::max(out.most, value);
    }
  return out;
}

}  // namespace

Image reduced_image(const Image& image, int divisor) {
  if (image.width % divisor != 0 || image.height % divisor != 0)
    throw InputError(fmt::format("its {} x {} px cannot be divided by {} in both directions", image.width,
                                 image.height, divisor));
  auto reduced = make_image(image.width / divisor, image.height / divisor, image.channels);
  reduced.attributes = image.attributes;
  const double count = static_cast<double>(divisor) * divisor;
  for (std::size_t c = 0; c < image.channel_count(); ++c) {
    const auto combination = combination_of(image.channels[c]);
    for (int y = 0; y < reduced.height; ++y)
      for (int x = 0; x < reduced.width; ++x)
        reduced.at(x, y, c) =
            static_cast<float>(value_of(combined_pixels(image, x, y, divisor, c), combination, count));
  }
  return reduced;
}

}  // namespace orbs::image
