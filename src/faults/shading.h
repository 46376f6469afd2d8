#pragma once

#include "base/rectangle.h"
#include "image/image.h"

#include <cstdint>
#include <limits>
#include <vector>

/// Faults that change the light of some pixels more than that of others. The variance follows.
namespace orbs::faults {

/// The light times 1 - x and - y at the left and upper edge, 1 + x and + y at the right and lower edge.
struct Gradient {
  double x = 0;
  double y = 0;
  image::Image apply(const image::Image& image) const;
};

/// Darker by `share` in the corners, by the square of the distance.
struct Vignette {
  double share = 0;
  image::Image apply(const image::Image& image) const;
};

/// Rectangles of width x height px in turn brighter and darker by `share`; 0: as wide or high as the image.
struct Pattern {
  int width_px = 1;
  int height_px = 1;
  double share = 0;
  image::Image apply(const image::Image& image) const;
};

/// The light times a factor in a rectangle.
struct Patch {
  Rectangle where;
  double factor = 1;
  image::Image apply(const image::Image& image) const;
};

/// The light times a factor where the luminance of the reference, divided by its mean radiance, is between
/// two values.
struct Brightness {
  const image::Image* reference = nullptr;
  double factor = 1;
  double above = -std::numeric_limits<double>::infinity();
  double below = std::numeric_limits<double>::infinity();
  image::Image apply(const image::Image& image) const;
};

/// Radiance added to R, G and B in a rectangle. The variances stay.
struct Leak {
  Rectangle where;
  double radiance = 0;
  image::Image apply(const image::Image& image) const;
};

/// The square patch of `side_px` whose mean luminance is the median of all such places 4 px off a grid of its
/// side; clipped to the image. Only patches whose pixels are all `included` count, and all do where that is
/// empty.
Rectangle middle_patch(const image::Image& reference,
                       int side_px,
                       const std::vector<std::uint8_t>& included = {});

/// A leak of the reference's mean light into 16 x 16 px, placed as above.
Leak leak_of_mean_light(const image::Image& reference, const std::vector<std::uint8_t>& included);

}  // namespace orbs::faults
