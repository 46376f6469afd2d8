#include "metrics/pixel_difference.h"

#include <cmath>

namespace orbs::metrics {

namespace {

double grey_at(const image::Image& image, int x, int y) {
  return (static_cast<double>(image.at(x, y, 0)) + static_cast<double>(image.at(x, y, 1)) +
          static_cast<double>(image.at(x, y, 2))) /
         3;
}

}  // namespace

PixelDifference pixel_difference(const image::Image& original, const image::Image& changed) {
  const auto first = image::select_rgb(original, "");
  const auto second = image::select_rgb(changed, "");
  PixelDifference out;
  double level = 0;
  double sum = 0;
  double largest = 0;
  for (int y = 0; y < first.height; ++y)
    for (int x = 0; x < first.width; ++x) {
      const double here = grey_at(first, x, y);
      const double difference = std::fabs(grey_at(second, x, y) - here);
      level += here;
      sum += difference;
      if (difference > largest) {
        largest = difference;
        out.x = x;
        out.y = y;
      }
    }
  out.mean = sum / (level > 0 ? level : static_cast<double>(first.pixel_count()));
  return out;
}

}  // namespace orbs::metrics
