#pragma once

#include "image/image.h"

/// How far two renders of one scene lie apart that had the same random numbers.
namespace orbs::metrics {

struct PixelDifference {
  double mean = 0;  // over the pixels, of the absolute difference of their grey; over the mean of `original`
  int x = 0;        // pixel that differs most
  int y = 0;
};

/// Where `original` is black there is nothing to be relative to: the difference itself is given then. Both
/// have the same size and the channels R, G, B.
PixelDifference pixel_difference(const image::Image& original, const image::Image& changed);

}  // namespace orbs::metrics
