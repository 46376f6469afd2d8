#include "metrics/mask.h"

#include "base/error.h"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

namespace orbs::metrics {

namespace {

void check_rectangle(const Rectangle& r, int width, int height) {
  if (0 <= r.x0 && r.x0 < r.x1 && r.x1 <= width && 0 <= r.y0 && r.y0 < r.y1 && r.y1 <= height) return;
  throw InputError(
      fmt::format("the masked rectangle [{}, {}, {}, {}] is not inside the {} x {} px image; expected "
                  "[x0, y0, x1, y1] with 0 <= x0 < x1 <= {} and 0 <= y0 < y1 <= {}",
                  r.x0, r.y0, r.x1, r.y1, width, height, width, height));
}

}  // namespace

std::vector<std::uint8_t> included_pixels(const Mask& mask, int width, int height) {
  const auto row_length = static_cast<std::size_t>(width);
  const std::size_t count = row_length * static_cast<std::size_t>(height);
  std::vector<std::uint8_t> included(count, 1);
  if (!mask.pixels.empty()) {
    if (mask.pixels.size() != count)
      throw InputError(fmt::format("the mask has {} pixels, the image {} ({} x {})", mask.pixels.size(),
                                   count, width, height));
    std::transform(mask.pixels.begin(), mask.pixels.end(), included.begin(),
                   [](std::uint8_t excluded) { return static_cast<std::uint8_t>(excluded == 0); });
  }
  for (const Rectangle& r : mask.rectangles) {
    check_rectangle(r, width, height);
    for (int y = r.y0; y < r.y1; ++y) {
      const auto row = included.begin() + static_cast<std::ptrdiff_t>(row_length) * y;
      std::fill(row + r.x0, row + r.x1, std::uint8_t{0});
    }
  }
  if (std::find(included.begin(), included.end(), 1) == included.end())
    throw InputError("the mask leaves no pixel to compare");
  return included;
}

}  // namespace orbs::metrics
