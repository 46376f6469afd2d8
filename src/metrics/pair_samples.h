#pragma once

#include "image/image.h"
#include "metrics/layer_samples.h"
#include "metrics/mask.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace orbs::metrics {

/// Where the noise of the result is known from. Variances: from its channels. Scatter: the result does not
/// know its noise, so it is estimated from the differences of neighbours; structure in the error then counts
/// as noise, and noise that a filter spreads over more than a few pixels is underestimated. Reference: the
/// result is known to have no noise, so only that of the reference counts. A reference without variances
/// counts as exact.
enum class NoiseSource { Variances, Scatter, Reference };

/// What is known of the result's noise beside its image. NoiseFree: its renderer draws no random samples, so
/// every difference beyond the reference's noise is an error.
enum class ResultNoise { AsTheImageSays, NoiseFree };

/// S1, S2, S3, each interleaved R, G, B.
using StokesSamples = std::array<std::vector<float>, 3>;

/// What the looks of an image tell of the noise that all of its pixels have in common, see common_noise.h.
struct CommonNoise {
  std::array<double, 3> error{};  // standard error of the mean of the image, linear R, G, B
  double degrees = 0;             // of freedom; 0: nothing is known of it
};

/// How many times the variance that its pixels state the sum over an area has, by channel.
struct AreaNoise {
  std::array<double, 3> over_8px{1, 1, 1};
  std::array<double, 3> over_16px{1, 1, 1};  // and more
};

/// The samples of two comparable images, unpacked once and shared by all metrics. Interleaved R, G, B.
struct PairSamples {
  int width = 0;
  int height = 0;
  std::vector<float> result;  // linear Rec.709, as given
  std::vector<float> reference;
  NoiseSource noise_source = NoiseSource::Variances;
  std::vector<float> result_variance;     // of the mean; empty unless noise_source is Variances
  std::vector<float> reference_variance;  // of the mean; empty: exact
  /// By channel the variance of the result over that of the reference; 0 where the reference has none, or the
  /// result is free of noise.
  std::array<double, 3> variance_ratio{};
  /// The same without what the numbers of samples say, see count_samples.
  std::array<double, 3> seen_variance_ratio{};
  /// What one of the hits brings that carry the result's noise, see rare_light.h.
  std::array<double, 3> hit_size{};
  /// How often the image may be looked at while it gets samples, see docs/understand/verdicts.md: the looks
  /// share the false alarms of every test evenly (Bonferroni).
  int looks = 1;
  int spp = 0;  // samples per pixel of the result; 0: not known
  CommonNoise common_noise = {};
  AreaNoise area_noise = {};
  /// How much light, as a share of the mean, the image may lack because no sample has found it, where the
  /// reference says nothing of it (rare_light.h); 0: none.
  double unseen_share = 0;
  std::optional<StokesSamples> result_stokes;  // nothing where the image has no Stokes parameters
  std::optional<StokesSamples> reference_stokes;
  std::optional<LayerSamples> layers;  // nothing where the reference holds none
  std::vector<std::uint8_t> included;  // 1: the pixel counts
  std::size_t included_count = 0;

  std::size_t pixel_count() const { return included.size(); }
  std::size_t pixel_at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
  double difference(std::size_t sample) const {
    return static_cast<double>(result[sample]) - static_cast<double>(reference[sample]);
  }
};

/// Unpacks images that have passed check_alignment. InputError when the mask does not fit them.
///
/// The variance ratio is that of the sums over the image, or the median of its blocks where that is larger: a
/// result that missed rare light states too little there, and most of its blocks know better; where the
/// blocks missed it, a few have seen it. No word of the image's provenance decides it.
PairSamples pair_samples(const image::Image& result,
                         const image::Image& reference,
                         const Mask& mask = {},
                         ResultNoise result_noise = ResultNoise::AsTheImageSays);

/// The result has 1 / `ratio` of the reference's samples, so its variance is taken to be `ratio` times the
/// reference's at least. Samples that all missed rare light do not know that they did, and make an image that
/// is too dark and sure of it; the reference has seen more of them. A renderer with a better estimator than
/// the reference's pays for this in samples, and not in errors.
void count_samples(PairSamples& samples, double ratio);

/// What one gate may do wrong to an image that lies on its limit, on one side, over all looks together: be
/// missed by a right one, and be met by a wrong one. For a pass there is no correction for channels and
/// tiles, as all of them must pass (intersection-union, Berger 1982); one that is missed decides alone, so
/// the tests of a gate share kWrongFails.
constexpr double kWrongFails = 2.5e-4;
constexpr double kWrongPasses = 1e-3;
/// Standard errors that leave out so much over twelve looks, of normally distributed noise. Where few numbers
/// tell the noise, Student's distribution asks for more than any right image has; a wrong one of which they
/// tell too little is caught by other windows, or at the next look.
constexpr double kErrorsToPass = 3.8;

/// Whether the image holds the layers S1, S2 and S3.
bool has_stokes(const image::Image& image);

/// The variance of a sample, 0 where there are none.
inline double variance_at(const std::vector<float>& variances, std::size_t sample) {
  return variances.empty() ? 0.0 : static_cast<double>(variances[sample]);
}

/// What one of the hits brings that carry the noise, in sums over pixels and by channel; rare_light.h derives
/// it. `variances` are those of the means of pixels, interleaved R, G, B; without any it is 0. `included`
/// says which pixels count (1); empty: all.
std::array<double, 3> hit_size(const std::vector<float>& variances,
                               const std::vector<std::uint8_t>& included);

/// Of the reference to its neighbours, for each sample of the row y: the larger step to either side, in x and
/// y together. Times a length in px it is at least what an edge makes in a pixel when it lies so far away.
void reference_steps(const PairSamples& samples, int y, std::vector<double>& steps);

/// Side of the blocks over which errors are averaged where single pixels are too noisy to be tested.
constexpr int kBlock_px = 8;

/// Calls visit(pixel) for each counted pixel of the block, by rows.
template <typename Visit>
void for_each_block_pixel(const PairSamples& samples, const Rectangle& block, Visit visit) {
  for (int y = block.y0; y < block.y1; ++y)
    for (int x = block.x0; x < block.x1; ++x)
      if (const auto pixel = samples.pixel_at(x, y); samples.included[pixel] != 0) visit(pixel);
}

/// Calls visit(pixel, right neighbour) for pairs of counted pixels of the rectangle; no pixel is in two.
template <typename Visit>
void for_each_pair(const PairSamples& samples, const Rectangle& rectangle, Visit visit) {
  for (int y = rectangle.y0; y < rectangle.y1; ++y)
    for (int x = rectangle.x0; x + 1 < rectangle.x1; x += 2)
      if (const auto pixel = samples.pixel_at(x, y);
          samples.included[pixel] != 0 && samples.included[pixel + 1] != 0)
        visit(pixel, pixel + 1);
}

/// Square blocks by rows, counted from the upper left corner; those at the right and lower edge may be
/// smaller.
std::vector<Rectangle> blocks_of(const PairSamples& samples, int side_px = kBlock_px);

/// A sum of variances and how many pixels carry it; noise_test.h says what for.
struct PooledVariance {
  double sum = 0;
  double squares = 0;

  void add(double variance) {
    sum += variance;
    squares += variance * variance;
  }
  void scale(double times) {
    sum *= times;
    squares *= times * times;
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
  DifferenceVariance(const PairSamples& samples,
                     std::size_t channel,
                     double weight,
                     const std::array<double, 3>& variance_ratio)
      : samples_(samples), channel_(channel), weight_(weight), variance_ratio_(variance_ratio.at(channel)) {}

  void add(std::size_t pixel) {
    const std::size_t i = 3 * pixel + channel_;
    const double of_reference = variance_at(samples_.reference_variance, i);
    own_.add(variance_at(samples_.result_variance, i) + weight_ * weight_ * of_reference);
    expected_.add((variance_ratio_ + weight_ * weight_) * of_reference);
    of_reference_ += weight_ * weight_ * of_reference;
  }
  /// The part of the sum that stays however many samples the result gets.
  double of_reference() const { return of_reference_; }
  const PooledVariance& pooled() const { return own_.sum >= expected_.sum ? own_ : expected_; }

 private:
  const PairSamples& samples_;
  std::size_t channel_;
  double weight_;
  double variance_ratio_;
  double of_reference_ = 0;
  PooledVariance own_;
  PooledVariance expected_;
};

}  // namespace orbs::metrics
