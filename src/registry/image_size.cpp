#include "registry/image_size.h"

#include "base/error.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace orbs::registry {

std::string size_text(int divisor) { return divisor == 1 ? "1" : fmt::format("1/{}", divisor); }

SizeDivisor size_divisor(std::string_view text) {
  for (const auto divisor : kSizeDivisors)
    if (size_text(divisor) == text) return divisor;
  throw InputError(fmt::format("'{}' is no size; there are 1, 1/2, 1/4 and 1/8 of the full width", text));
}

int divisor_of_image(int width_px, int height_px, const ReducedSize& size) {
  int found = FullSize;
  for (const int divisor : kSizeDivisors)
    if (divisor <= size.divisor && width_px % divisor == 0 && height_px % divisor == 0 &&
        std::min(width_px, height_px) / divisor >= size.least_side_px)
      found = divisor;
  return found;
}

namespace {

int rounded_up(int pixel, int divisor) { return (pixel + divisor - 1) / divisor; }

Rectangle grown(const Rectangle& full, int divisor) {
  return {full.x0 / divisor, full.y0 / divisor, rounded_up(full.x1, divisor), rounded_up(full.y1, divisor)};
}

Rectangle shrunk(const Rectangle& full, int divisor) {
  return {rounded_up(full.x0, divisor), rounded_up(full.y0, divisor), full.x1 / divisor, full.y1 / divisor};
}

bool are_equal(const Rectangle& a, const Rectangle& b) {
  return a.x0 == b.x0 && a.y0 == b.y0 && a.x1 == b.x1 && a.y1 == b.y1;
}

}  // namespace

Case reduced_case(Case one_case, const std::function<int(const std::string& target)>& divisor_of) {
  for (auto& mask : one_case.masks)
    for (auto& rectangle : mask.rectangles) rectangle = grown(rectangle, divisor_of(mask.target));
  for (auto& check : one_case.pixel_checks) {
    const int divisor = divisor_of(check.target);
    if (divisor == 1) continue;
    const auto region = shrunk(check.region, divisor);
    // A mean that is checked within its standard errors is that of exactly these pixels: where the image has
    // a gradient, a part of them has another one.
    const bool is_a_part = check.standard_errors > 0 && !are_equal(region, grown(check.region, divisor));
    if (is_a_part) {
      check.not_measured = fmt::format(
          "not measured at {}: the mean of these pixels is not that of whole ones there", size_text(divisor));
    } else if (region.x0 < region.x1 && region.y0 < region.y1) {
      check.region = region;
    } else {
      check.not_measured = fmt::format("not measured at {}: these pixels of the full size fill none there",
                                       size_text(divisor));
    }
  }
  return one_case;
}

Case reduced_case(Case one_case, int divisor) {
  return reduced_case(std::move(one_case), [&](const std::string& /*target*/) { return divisor; });
}

}  // namespace orbs::registry
