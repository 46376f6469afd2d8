#pragma once

#include "image/image.h"
#include "metrics/mask.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace orbs::metrics {

/// What the statistics of two images are made from. Samples are interleaved R, G, B.
struct NoiseSamples {
  int width = 0;
  int height = 0;
  std::vector<float> result;
  std::vector<float> reference;
  std::vector<float> result_variance;     // of the mean; empty where the image does not know it
  std::vector<float> reference_variance;  // of the mean; empty: exact
  std::vector<std::uint8_t> included;     // 1: the pixel counts
  /// By channel how many times the variance of the result is that of the reference; 0 where nobody knows.
  std::array<double, 3> variance_ratio{};

  double difference(std::size_t sample) const {
    return static_cast<double>(result[sample]) - static_cast<double>(reference[sample]);
  }
};

/// The variance ratio is that of the sums, or, where it is larger, that of the numbers of samples that the
/// provenance records of images of one program say ("orbs.program", "orbs.spp"): a result that missed what is
/// rare knows nothing of it.
NoiseSamples noise_samples(const image::Image& result, const image::Image& reference, const Mask& mask);

/// The value of a variance, 0 where there are none.
inline double variance_at(const std::vector<float>& variances, std::size_t sample) {
  return variances.empty() ? 0.0 : static_cast<double>(variances[sample]);
}

/// Calls visit(pixel) for each counted pixel of the block, by rows.
template <typename Visit>
void for_each_block_pixel(const NoiseSamples& samples, const Rectangle& block, Visit visit) {
  for (int y = block.y0; y < block.y1; ++y)
    for (int x = block.x0; x < block.x1; ++x) {
      const auto pixel =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(samples.width) + static_cast<std::size_t>(x);
      if (samples.included[pixel] != 0) visit(pixel);
    }
}

/// Blocks of kBlock_px by rows, counted from the upper left corner; those at the right and lower edge may be
/// smaller.
std::vector<Rectangle> blocks_of(const NoiseSamples& samples);

/// A sum of variances and how many pixels carry it; see noise_test.h.
struct PooledVariance {
  double sum = 0;
  double squares = 0;

  void add(double variance) {
    sum += variance;
    squares += variance * variance;
  }
  /// (sum w)^2 / sum w^2, at least 1 by Cauchy and Schwarz; 1 for no variance at all.
  double degrees() const { return squares > 0 ? sum * sum / squares : 1.0; }
};

/// Variance of sum(result - weight * reference) over pixels of one channel. The result's own variance is too
/// small by accident where its samples missed what is rare, and just there its mean is too dark. The
/// reference has seen more: its variance, scaled to the result's samples, is taken where the sum of these is
/// larger.
class DifferenceVariance {
 public:
  DifferenceVariance(const NoiseSamples& samples, std::size_t channel, double weight)
      : samples_(samples), channel_(channel), weight_(weight) {}

  void add(std::size_t pixel) {
    const std::size_t i = 3 * pixel + channel_;
    const double of_reference = variance_at(samples_.reference_variance, i);
    own_.add(variance_at(samples_.result_variance, i) + weight_ * weight_ * of_reference);
    expected_.add((samples_.variance_ratio.at(channel_) + weight_ * weight_) * of_reference);
  }
  const PooledVariance& pooled() const { return own_.sum >= expected_.sum ? own_ : expected_; }

 private:
  const NoiseSamples& samples_;
  std::size_t channel_;
  double weight_;
  PooledVariance own_;
  PooledVariance expected_;
};

}  // namespace orbs::metrics
