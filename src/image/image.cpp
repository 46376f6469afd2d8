#include "image/image.h"

#include "base/error.h"

#include <algorithm>
#include <array>
#include <cassert>
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

bool is_variance(std::string_view channel) { return channel.starts_with("variance."); }

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

}  // namespace orbs::image
