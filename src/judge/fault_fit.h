#pragma once

#include "base/rectangle.h"
#include "image/image.h"
#include "metrics/mask.h"

#include <vector>

/// How well a candidate image explains the difference of a result and its reference.
///
/// All errors are squares of w (result - image) of R, G, B, with
///   w = 1 / (mean of |result| and |reference| over 5 x 5 px and R, G, B + a tenth of that over the image).
/// So an error counts by its size relative to the light around it, and what is darker than a tenth of the
/// mean counts for less. The weight is the same for all candidates, and over 25 px it hardly follows the
/// noise of a pixel, so that the mean of the weighted noise is zero.
namespace orbs::judge {

struct FitSamples {
  image::Image result;        // R, G, B
  image::Image reference;     // R, G, B
  std::vector<float> weight;  // by pixel; 0: masked
};

FitSamples fit_samples(const image::Image& result, const image::Image& reference, const metrics::Mask& mask);

/// Means over the counted pixels of a rectangle.
struct Fit {
  double before = 0;          // squared error of result - reference
  double after = 0;           // squared error of result - candidate
  double standard_error = 0;  // of before - after, by the scatter of what is left
};

Fit fit_of(const FitSamples& samples, const image::Image& candidate, const Rectangle& where);

/// Mean squared error of result - a less that of result - b, and the standard error of this difference
/// where b is right.
struct Advantage {
  double value = 0;
  double standard_error = 0;
};
Advantage advantage(const FitSamples& samples,
                    const image::Image& a,
                    const image::Image& b,
                    const Rectangle& where);

/// What of the error that the candidate leaves is no noise. Noise is independent from pixel to pixel, so
/// what neighbours and blocks of 2, 4 and 8 px have in common is not: the largest of these, less four times
/// `doubt`. Where the candidate averages pixels, its noise is not independent: then by how much the error is
/// larger in that half of the pixels of each block of 8 px that the candidate changes most.
struct Unexplained {
  double squared = 0;  // mean squared error that is structure, at least 0
  double doubt = 0;  // standard error of it, by Welch's and Satterthwaite's count of the pixels that carry it
};
Unexplained unexplained_by(const FitSamples& samples,
                           const image::Image& candidate,
                           const Rectangle& where,
                           bool averages_noise);

}  // namespace orbs::judge
