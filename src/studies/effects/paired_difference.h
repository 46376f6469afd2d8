#pragma once

#include "image/image.h"
#include "scene/relations/relation.h"

#include <vector>

namespace orbs::studies {

/// A difference relative to a level of the original image, and its standard error.
struct RelativeDifference {
  double value = 0;
  double standard_error = 0;
  double confidence = 0;  // that it is no noise: 1 - probability, times the number of means looked at
};

inline constexpr int kStabilityBlock_px = 8;

/// Images of a changed scene minus those of the original one, in pairs of the same seed.
struct PairedDifference {
  bool is_equal = false;       // all pairs, to the bit
  RelativeDifference mean;     // relative to the mean of the original image
  RelativeDifference largest;  // the block of 8 x 8 px that differs most for sure, relative to its mean
  int x = 0;                   // the block's upper left pixel
  int y = 0;
  double pixels = 0;  // mean of the absolute differences of single pixels, relative to the image's mean
};

/// The colours of the image of a changed scene, turned back into what the original scene shows.
image::Image original_of(const image::Image& changed, const scene::RelatedImage& related);

/// Pairs of images of one size, at least one. The standard error follows from the scatter of each pixel's
/// difference over the pairs; the degrees of freedom are those of Welch and Satterthwaite, so that a few
/// pixels with outliers do not count as evidence. One pair is taken to be free of noise. A block's level is
/// its mean, but at least a tenth of the image's. "For sure": of the blocks whose confidence is 0.9999 the
/// one with the largest magnitude; if there is none, the one with the greatest confidence.
PairedDifference paired_difference(const std::vector<image::Image>& original,
                                   const std::vector<image::Image>& changed);

/// Mean over the pairs of changed - original, as an image with channels R, G, B.
image::Image mean_difference(const std::vector<image::Image>& original,
                             const std::vector<image::Image>& changed);

inline constexpr double kSure = 0.9999;

}  // namespace orbs::studies
