#pragma once

#include "base/statistics.h"
#include "image/image.h"
#include "metrics/block_scores.h"
#include "metrics/line_error.h"
#include "metrics/mask.h"
#include "metrics/near_areas.h"
#include "metrics/pair_samples.h"
#include "metrics/patterns.h"
#include "metrics/residual.h"
#include "metrics/window_error.h"

#include <array>
#include <optional>
#include <vector>

/// Is an image wrong, or only noisy? Statistics of result - reference in linear Rec.709, from the variances
/// of the mean that the images carry in "variance.R/G/B".
///
/// What the tests rest on:
/// - The noise of different pixels is independent (a box filter, no denoiser), and so is that of the two
///   images (other seeds). A sum over pixels then has the sum of their variances, and each of these may be
///   as rough as it likes as long as it is not biased: the sum pools them.
/// - The sum of the estimates is rough where few pixels carry it. By Welch and Satterthwaite a sum of
///   estimates w_i with f_i degrees of freedom each has (sum w)^2 / sum(w^2 / f) of them. f is not known, as
///   the values that a pixel averages may be rare and large; we take 1, the least there is. So the degrees of
///   freedom are the number of pixels that carry the variance, thousands in an ordinary image, and few
///   where fireflies rule it: Student's distribution then makes the intervals as wide as honest ones must be.
/// - What neither image has seen, no test can know: light that arrives once in more samples than both have.
///   Nor what the result alone has not seen where the reference keeps its variance and samples to itself.
namespace orbs::metrics {

/// How many control images in total are called wrong; the tests share it evenly: mean ratio, blocks, squares
/// everywhere and away from edges, patterns, correlation, and the three of the stated and shared noise
/// together.
constexpr double kFalseAlarms = 1e-3;
constexpr int kTests = 7;
// Every Interval here leaves out a right image with the probability kFalseAlarms / kTests at most (those of
// the three channels of a mean ratio together).

/// Whether the noise that the images state is there. NearerThanReference: the squared differences are less
/// than half of what the noise of the reference alone makes them, so the result shares the reference's
/// samples: it is a copy, or was made with its seed. OverstatedByResult: they are less than half of what both
/// images state, so the result's variances are too large, as those of single samples instead of those of
/// their mean.
enum class StatedNoise { Plausible, NearerThanReference, OverstatedByResult };

/// What is left of the squared error away from edges.
struct SmoothResidual {
  Interval bias_squared;
  double reference_squared = 0;  // mean square of the reference at these pixels
};

struct MeanRatio : Interval {
  /// By which a gate is met, where an image is looked at more than once: what is too dark for lack of rare
  /// light must not be called wrong, and is met by none. The interval itself at one look.
  Interval to_pass;
  double reference_share = 0;  // of the variance, which no samples of the result make less
  /// Half the width of the interval as its pixels alone make it; what they have in common may make it wider.
  double reach_of_pixels = 0;
};

struct NoiseTest {
  NoiseSource source = NoiseSource::Variances;
  StatedNoise stated = StatedNoise::Plausible;
  /// mean(result) / mean(reference) - 1 of R, G, B; nothing where the mean of the reference is not above ten
  /// times its own noise (black, or a difference of images), as the ratio then says nothing.
  std::array<std::optional<MeanRatio>, 3> mean_ratio;
  double noise_squared = 0;              // the MSE that the noise of both images explains
  Interval bias_squared;                 // what is left of the MSE; below zero by chance
  double reference_squared = 0;          // mean square of the reference, the measure of what is negligible
  double edge_squared = 0;               // mean square of what edges make that lie 0.15 px away
  std::optional<SmoothResidual> smooth;  // by variances only; nothing with fewer than 1000 smooth pixels
  BlockScores blocks;
  WindowErrors windows;
  std::optional<LineError> line;
  /// Every pattern whose whole interval lies beyond what is negligible, that which stands out most first.
  std::vector<PatternFinding> patterns;
  std::optional<Correlation> correlation;
  std::optional<PixelScores> pixels;     // by the result's variances only
  std::optional<NearAreas> near_areas;   // with a false alarm in a million images
  std::optional<Interval> shared_noise;  // share of the reference's own noise that the result holds
};

NoiseTest test_noise(const PairSamples& samples);

/// As above. The images must have passed check_alignment; InputError when the mask does not fit them.
NoiseTest test_noise(const image::Image& result,
                     const image::Image& reference,
                     const Mask& mask = {},
                     ResultNoise result_noise = ResultNoise::AsTheImageSays);

/// Whether bias_squared is above zero for sure, and above what is negligible.
bool is_square_biased(const NoiseTest& test);

/// The same where it is also more than antialiasing on a grid makes at edges, so that a reader is to be told.
bool is_square_biased_beyond_edges(const NoiseTest& test);

/// The same away from edges, where correct renderers do not differ.
bool is_residual(const NoiseTest& test);

/// Whether the result holds more than a quarter of the reference's own noise for sure, so that it was made
/// from the reference, or with its seed. A quarter, as the variances of references are stored to 2
/// significant bits.
bool holds_reference_noise(const NoiseTest& test);

/// The mean ratio that is farthest from zero of those whose whole interval lies beyond kNegligible; nothing
/// when there is none.
std::optional<Interval> mean_error(const NoiseTest& test);

}  // namespace orbs::metrics
