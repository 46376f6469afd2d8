#include "fuzz/feed.h"
#include "image/image_io.h"

namespace orbs::fuzz {

std::string feed_exr(std::string_view bytes) {
  return complaint_of("picture.exr", [&] {
    const auto picture = image::read_exr("picture.exr", bytes);
    require(picture.width > 0 && picture.height > 0 && !picture.channels.empty(), "a picture has pixels");
    require(picture.pixels.size() == picture.pixel_count() * picture.channel_count(), "all pixels are there");
    float sum = 0;
    for (const float value : picture.pixels) sum += value;
    require(sum == sum || sum != sum, "pixels can be looked at");
  });
}

}  // namespace orbs::fuzz
