#include "fuzz/feed.h"
#include "image/image_io.h"

namespace orbs::fuzz {

std::string feed_exr(std::string_view bytes) {
  return complaint_of("image.exr", [&] {
    const auto image = image::read_exr("image.exr", bytes);
    require(image.width > 0 && image.height > 0 && !image.channels.empty(), "an image has pixels");
    require(image.pixels.size() == image.pixel_count() * image.channel_count(), "all pixels are there");
    float sum = 0;
    for (const float value : image.pixels) sum += value;
    require(sum == sum || sum != sum, "pixels can be looked at");
  });
}

}  // namespace orbs::fuzz
