#pragma once

#include "image/image.h"

#include <string>

/// Faults that mix the values of neighbouring pixels.
namespace orbs::faults {

/// By a filter wider than a pixel, over all channels. The variances are averaged like the values: the noise
/// of the pixels is no longer independent, and over an area that gives the right variance of the mean.
struct Blur {
  enum class Filter { Gaussian, Box };
  double width_px = 1;  // standard deviation of the Gaussian, which is cut at three of them; side of the box
  Filter filter = Filter::Gaussian;
  double share = 1;  // 1 blurs; -1 adds what the blur would take away
  image::Image apply(const image::Image& image) const;
  std::string text() const;
};

/// The median of 3 x 3 px in each channel.
struct Median {
  image::Image apply(const image::Image& image) const;
};

/// Rendered with fewer pixels, scaled up: the means of squares in place of their pixels, those that there are
/// at the edges. The variance of a mean of n is their sum / n^2.
struct Resolution {
  int side_px = 2;
  image::Image apply(const image::Image& image) const;
  std::string text() const;
};

}  // namespace orbs::faults
