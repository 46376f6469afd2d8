#pragma once

#include "base/rectangle.h"
#include "metrics/pair_samples.h"

#include <cstddef>

namespace orbs::metrics {

/// Light that few samples find, and how much of it a region may be too dark without being wrong.
///
/// A region whose samples all missed rare light is too dark, and sure of it: its variance is that of the
/// samples that it has. How much one sample of that light brings is seen elsewhere in the image. If one
/// brings h and the region lacks t, t / h of them were to be expected, and by Poisson none arrived with the
/// probability exp(-t / h). So a region that lacks less than h ln(1 / p) is not wrong with the certainty 1 -
/// p.
///
/// The size of a hit (hit_size in pair_samples.h) is sum(v^1.5) / sum(v) over the image, with v the variance
/// of a pixel's mean: one hit of x in n samples adds x / n to the mean and (x / n)^2 to its variance. The
/// weights make it that of the hits that carry the noise. Where the noise is even it is the deviation of a
/// pixel, and ln(1 / p) of these are fewer than Student's reach over a window of 64.
///
/// It counts only where the region does not know its noise: fewer than ten pixels carry its variance (of
/// which the estimate is off by 45 %, sqrt(2 / 10)). A region with even noise that is too dark in one image
/// with fireflies elsewhere is not excused.

/// How much the sum over a region with this noise may be too small for want of hits of this size;
/// `probability` is that of a right image to be smaller yet. 0 where the region knows its noise.
double unseen_light(double hit, const PooledVariance& noise, double probability);

/// The same of a region of the pair.
double unseen_light(const PairSamples& samples,
                    const Rectangle& region,
                    std::size_t channel,
                    double probability);

/// The share of its mean that an image may lack for want of hits, where it is compared with a reference that
/// was computed: such a reference has no variance that could tell of light which the image has not met. Light
/// that one sample in 100,000 brings is missed by N samples of all pixels together with the probability
/// exp(-N / 100,000). As long as that is more than kWrongFails, below 830,000 samples, a tenth of the light
/// may be such; from then on the image has met some of it, and knows its noise. 0 where the reference has
/// noise, and for `spp` 0.
double unseen_share(const PairSamples& samples, int spp);

}  // namespace orbs::metrics
