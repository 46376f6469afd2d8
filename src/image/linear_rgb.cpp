#include "image/linear_rgb.h"

#include "image/colour.h"
#include "image/image_io.h"

namespace orbs::image {

Image read_linear_rgb(const std::filesystem::path& file) {
  const Image picture = read_image(file);
  const bool encoded = is_ldr_file(file);
  const bool grey = picture.channel_count() < 3;
  Image linear = make_image(picture.width, picture.height, {"R", "G", "B"});
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        const float value = picture.at(x, y, grey ? 0 : c);
        linear.at(x, y, c) = encoded ? srgb_decode(value) : value;
      }
  return linear;
}

}  // namespace orbs::image
