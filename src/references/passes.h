#pragma once

#include "image/image.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace orbs::references {

/// One render of a scene among several with different seeds.
struct Pass {
  int spp = 0;
  std::uint64_t seed = 0;
};

/// Sums of passes, in double: n m of every channel and n^2 v of the channels "variance.*", where n is the
/// number of samples of a pass, m its mean and v the variance of that mean.
struct PassSum {
  int width = 0;
  int height = 0;
  std::map<std::string, std::vector<double>> channels;
  std::map<std::string, std::string> attributes;  // of the first pass
  std::vector<Pass> passes;
  int spp = 0;                // of all passes
  long long bad_samples = 0;  // as their headers say
};

/// Adds an image whose samples are independent of those before: another seed. A channel that a pass lacks (a
/// class of light paths that did not occur) counts as black. InputError when the size is another one.
void add_pass(PassSum& sum, const image::Image& image, const Pass& pass);

/// The mean of all samples, sum n m / N, and its variance, sum n^2 v / N^2, as the passes are independent.
/// R, G, B come first, then their variances, then the other channels by name. At least one pass is the
/// caller's promise.
image::Image mean_image(const PassSum& sum);

}  // namespace orbs::references
