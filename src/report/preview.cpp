#include "report/preview.h"

#include "image/colour.h"
#include "image/image_io.h"

#include <algorithm>
#include <cstddef>

namespace orbs::report {

namespace {

// Means of the displayed values, not of the light: what a viewer does that shrinks the PNG, so that the image
// does not change its look when the floats arrive and are drawn pixel by pixel.
image::Image shrunk(const image::Image& shown, int factor) {
  const auto pieces = [&](int size) { return (size + factor - 1) / factor; };
  auto small = image::make_image(pieces(shown.width), pieces(shown.height), shown.channels);
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x) {
      const int right = std::min(shown.width, (x + 1) * factor);
      const int bottom = std::min(shown.height, (y + 1) * factor);
      for (std::size_t c = 0; c < shown.channel_count(); ++c) {
        double sum = 0;
        for (int v = y * factor; v < bottom; ++v)
          for (int u = x * factor; u < right; ++u) sum += static_cast<double>(shown.at(u, v, c));
        small.at(x, y, c) = static_cast<float>(sum / ((right - x * factor) * (bottom - y * factor)));
      }
    }
  return small;
}

}  // namespace

std::string preview_png(const image::Image& image) {
  const auto shown = image::display_image(image);
  const int side = std::max(shown.width, shown.height);
  const int factor = (side + kPreviewSide_px - 1) / kPreviewSide_px;
  return image::png_bytes(factor <= 1 ? shown : shrunk(shown, factor));
}

}  // namespace orbs::report
