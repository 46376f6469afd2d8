#pragma once

#include "image/image.h"

#include <string>
#include <vector>

namespace orbs::studies {

/// The mean of a number over several rounds.
struct MeanOfRounds {
  double value = 0;
  double standard_error = 0;
};

/// The difference between an alternative's image and the usual one, in Rec.709 luminance relative to the mean
/// of the usual image.
struct ImageChange {
  bool is_equal = false;  // to the bit, in all rounds
  MeanOfRounds mean;
  MeanOfRounds largest;  // that of the block of 8 x 8 px that differs most
  int x = 0;             // the block's upper left pixel
  int y = 0;
  std::string bias;  // how the difference exceeds noise, in words; "" if it does not
  /// False if only one of the two traces light paths: the other finds caustics too rarely to be compared.
  bool is_comparable = true;
};

/// Renders of the same scene one way and the other, in pairs of the same seed; at least two pairs of one
/// size.
ImageChange change_between(const std::vector<image::Image>& usual, const std::vector<image::Image>& other);

/// Mean over the channels and pixels of the variance of the mean that the images carry; mean of all
/// images.
double mean_variance(const std::vector<image::Image>& images);

}  // namespace orbs::studies
