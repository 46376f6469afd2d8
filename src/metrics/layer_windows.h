#pragma once

#include "metrics/metric.h"

#include <string>

namespace orbs::metrics {

/// The mean of a layer over a window that is farthest off for certain. All is relative to what the pixels
/// show: to the length of the largest vector in each, whose parts are the layer's channels.
struct LayerWindow {
  Rectangle where{};
  std::string what;    // "the mean of depth.Z over 8 x 8 px is off by 1 %"
  double certain = 0;  // what is left of it beyond its reach
};

/// How many numbers worst_window compares with zero.
double window_tests(const PairSamples& samples, const ComparedLayer& layer);

/// Windows are squares of 8, 16, 32, ... px up to the whole image. Compared are each channel and, of vectors,
/// the part along the vector itself, which another unit changes alone. Pixels that a surface covers in part
/// do not count, as renderers differ in what they write there.
///
/// The reach has two parts. Noise: pixels are weighted by the inverse of the variance that one sample has at
/// most, the square of half of the range that the pixel shows (Popoviciu 1935); the error of that mean is the
/// smaller of what these bounds make and of what the pixels' scatter about it shows, by Student's
/// distribution and with room for what no sample met, as a renderer with more samples scatters less. Place:
/// samples that lie alike in all pixels, eight of them at i / 8, have their middle 1 / 16 px off; and the
/// middle of a pixel differs from its mean by 1 / 24 of the second difference of a smooth layer.
/// `false_alarms`: of one of the tests.
LayerWindow worst_window(const PairSamples& samples, const ComparedLayer& layer, double false_alarms);

}  // namespace orbs::metrics
