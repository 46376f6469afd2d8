#include "base/files.h"
#include "fuzz/feed.h"
#include "image/image_io.h"

#include <array>

namespace orbs::fuzz {

// The first byte, modulo their number, says which of the other formats the rest is.
std::string feed_image(std::string_view bytes) {
  static const ScratchFolder folder("orbs-feed-image");
  constexpr std::array kEndings{".png", ".jpg", ".hdr", ".bmp", ".tga", ".pfm", ".ppm", ".pgm"};
  if (bytes.empty()) return "";
  const auto format = static_cast<unsigned char>(bytes.front()) % kEndings.size();
  const auto file = folder.path() / (std::string("image") + kEndings[format]);
  write_file(file, bytes.substr(1));
  return complaint_of(file.string(), [&] {
    const auto image = image::read_image(file);
    require(image.pixels.size() == image.pixel_count() * image.channel_count(), "all pixels are there");
  });
}

}  // namespace orbs::fuzz
