#pragma once

#include "base/vec.h"

#include <algorithm>
#include <array>

namespace orbs::spectra {

/// The wavelengths of one path: the hero, which chooses where the path goes, and three companions that come
/// along (Wilkie et al. 2014, "Hero Wavelength Spectral Sampling"). Each has its own density per nm.
struct Wavelengths {
  std::array<float, 4> nm{};
  std::array<float, 4> pdf{};
};

/// Four wavelengths within kShortestSeen_nm to kLongestSeen_nm from one number in [0, 1). The companions lie
/// at u + k / 4 on the circle of the cumulative distribution, so that every four of them are stratified and
/// each alone has the density that stands beside it.
///
/// Density: the square root of D65 times the length of the RGB matching functions. That product itself would
/// give the least noise for single independent samples of grey (Cauchy and Schwarz), but four stratified ones
/// integrate smooth functions so well that flatter densities win: the noise of one path on grey, root mean
/// square over the channels, is 0.28 with the product, 0.69 with a uniform density, and 0.10 with the root;
/// on the ColorChecker 0.10, 0.26 and 0.04.
Wavelengths sample_wavelengths(float u);

/// The number for sample_wavelengths from two of a stratified point. The first places all four wavelengths
/// within their quarters of the distribution, the second says which of them is the hero. So n samples whose
/// first numbers are stratified have 4 n wavelengths in as many strata; one number for both would place them
/// in n / 4 strata alone, of four samples each. Points that are stratified in both numbers as a (0, 2)-net
/// stratify the heroes, too.
inline float wavelength_number(float place, float hero) {
  constexpr float kLargest = 1 - 0x1p-24F;  // the sum is rounded, and could give 1
  return std::min(kLargest, (static_cast<float>(static_cast<int>(4 * hero)) + place) / 4);
}

}  // namespace orbs::spectra
