#include "image/reduced_image.h"

#include "base/error.h"

#include <fmt/format.h>

namespace orbs::image {

Image reduced_image(const Image& image, int divisor) {
  if (image.width % divisor != 0 || image.height % divisor != 0)
    throw InputError(fmt::format("its {} x {} px cannot be divided by {} in both directions", image.width,
                                 image.height, divisor));
  auto reduced = make_image(image.width / divisor, image.height / divisor, image.channels);
  reduced.attributes = image.attributes;
  const double count = static_cast<double>(divisor) * divisor;
  for (std::size_t c = 0; c < image.channel_count(); ++c) {
    const double scale = is_variance(image.channels[c]) ? 1 / (count * count) : 1 / count;
    for (int y = 0; y < reduced.height; ++y)
      for (int x = 0; x < reduced.width; ++x) {
        double sum = 0;
        for (int v = y * divisor; v < (y + 1) * divisor; ++v)
          for (int u = x * divisor; u < (x + 1) * divisor; ++u) sum += static_cast<double>(image.at(u, v, c));
        reduced.at(x, y, c) = static_cast<float>(sum * scale);
      }
  }
  return reduced;
}

}  // namespace orbs::image
