#pragma once

#include "metrics/image_pair.h"

#include <optional>

namespace orbs::judge {

/// What is left of the squared error of psnr_srgb8 when all noise is taken away, in squared steps of 1/255.
///
/// With A and A' two halves of the result's samples and R the reference, mean((A - R)(A' - R)) has the
/// expectation bias^2 + variance of R, whatever the law of the noise: that of A and A' is independent. The
/// curve bends, so the display value of a noisy pixel is off by half its second derivative times the
/// variance, and the product keeps the square of that: 1 to 13 % of the noise's own square while the noise is
/// large, falling with the square of the samples. The gate leaves room for it.
struct PsnrBias {
  double squared = 0;  // below 0 by chance
  double standard_error = 0;
  double degrees = 1;          // of freedom of the standard error, by the blocks that carry it
  double noise = 0;            // what noise adds to the squared error now
  double expected_noise = 0;   // the same by the reference's variance and the numbers of samples, if larger
  double reference_noise = 0;  // the part of it that is the reference's
};

/// Nothing where the pair has no halves.
std::optional<PsnrBias> psnr_bias(const metrics::ImagePair& pair);

}  // namespace orbs::judge
