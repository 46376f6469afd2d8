#pragma once

#include "image/image.h"
#include "metrics/mask.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace orbs::metrics {

/// Two comparable images in the forms that metrics need, each made once and shared. Samples are interleaved
/// R, G, B.
struct ImagePair {
  int width = 0;
  int height = 0;
  int threads = 1;
  std::vector<float> result;  // linear, as given
  std::vector<float> reference;
  std::vector<float> result_display;  // clamped to [0, 1], then sRGB-encoded
  std::vector<float> reference_display;
  std::vector<double> result_luma;  // .2126 R + .7152 G + .0722 B of the display values
  std::vector<double> reference_luma;
  std::vector<std::uint8_t> included;  // 1: the pixel counts
  std::size_t included_count = 0;

  std::size_t pixel_count() const { return included.size(); }
};

/// Both images must have passed check_alignment. `threads` is how many a metric may use; no result depends
/// on it. InputError when the mask does not fit the images.
ImagePair make_image_pair(const image::Image& result,
                          const image::Image& reference,
                          const Mask& mask,
                          int threads);

}  // namespace orbs::metrics
