#pragma once

#include "image/image.h"
#include "metrics/common_noise.h"
#include "metrics/mask.h"
#include "metrics/noise_test.h"
#include "metrics/pair_samples.h"

#include <array>
#include <vector>

namespace orbs::metrics {

/// Two comparable images in all forms that metrics need, each made once and shared.
struct ImagePair : PairSamples {
  int threads = 1;
  std::vector<float> result_display;  // clamped to [0, 1], then sRGB-encoded; interleaved R, G, B
  std::vector<float> reference_display;
  std::vector<double> result_luma;  // .2126 R + .7152 G + .0722 B of the display values
  std::vector<double> reference_luma;
  /// Two halves of the result's samples, independent of each other, in the form of result_display; empty
  /// where there are none.
  std::array<std::vector<float>, 2> half_display;
  NoiseTest noise;
};

struct PairSettings {
  int threads = 1;  // that a metric may use, 0: all cores; no result depends on it
  ResultNoise result_noise = ResultNoise::AsTheImageSays;
  int looks = 1;                                        // see PairSamples
  double sample_ratio = 0;                              // see count_samples; 0: not known
  const std::array<image::Image, 2>* halves = nullptr;  // of the result's samples
  std::vector<RendersApart> apart = {};                 // by look, see common_noise.h
  int spp = 0;                                          // samples per pixel of the result; 0: not known
};

/// Both images must have passed check_alignment. InputError when the mask does not fit them.
ImagePair make_image_pair(const image::Image& result,
                          const image::Image& reference,
                          const Mask& mask = {},
                          const PairSettings& settings = {});

}  // namespace orbs::metrics
