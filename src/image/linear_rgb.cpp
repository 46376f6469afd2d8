#include "image/linear_rgb.h"

#include "base/error.h"
#include "image/colour.h"
#include "image/image_io.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::image {

namespace {

// 1 or 3. Alpha has its place behind the colours.
std::size_t colour_count(const Image& image, const std::filesystem::path& file) {
  const auto most = std::min<std::size_t>(image.channel_count(), 3);
  std::size_t count = 1;
  while (count < most && image.channels[count] != "A") ++count;
  if (count == 2)
    throw InputError(fmt::format("{}: has the channels {}; expected one colour or three, and alpha as 'A'",
                                 file.string(), fmt::join(image.channels, ", ")));
  return count;
}

}  // namespace

Image read_linear_rgb(const std::filesystem::path& file) {
  const Image image = read_image(file);
  const bool encoded = is_ldr_file(file);
  const bool grey = colour_count(image, file) == 1;
  Image linear = make_image(image.width, image.height, {"R", "G", "B"});
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        const float value = image.at(x, y, grey ? 0 : c);
        linear.at(x, y, c) = encoded ? srgb_decode(value) : value;
      }
  return linear;
}

}  // namespace orbs::image
