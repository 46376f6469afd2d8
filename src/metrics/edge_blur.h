#pragma once

#include "metrics/metric.h"

#include <optional>
#include <string>

namespace orbs::metrics {

/// How much softer the edges of an image are than those of the reference: half the resolution, a filter over
/// several pixels, a denoiser. Where an image is smooth, these lower the noise by more than they cost in
/// edges, and its PSNR rises.
///
/// With b the reference after the filter [1 2 1] / 4 in x and y, of all pixels and channels at an edge
///   value = sum sign(b - reference) (result - reference) / sum |b - reference|,
/// each divided by its scale, b + the mean of the reference. 0: as sharp, 1: as if filtered so, below 0:
/// sharper. A quotient of sums, not least squares, in which a few edges of light sources would decide.
///
/// At an edge |b - reference| is above 5 % of the scale and above five times its own standard deviation, by
/// the reference's variance. So noise does not turn a sign, and what has a sure sign has noise that cancels:
/// the result's, and the reference's, which is in the error and in b - reference both and would else look
/// like a blur of the result (0.05 in control images of caustics). A reference that does not know its noise
/// counts as exact.
struct EdgeBlur {
  double value = 0;
  double standard_error = 0;  // by the scatter of the pixels about the value; the channels of one are one
  double degrees = 1;         // of freedom of the standard error
  // By the reference's variances, where the image is looked at several times: as the numbers of samples have
  // it, and as the whole image shows.
  double counted_error = 0;
  double seen_error = 0;
};

/// Linear Rec.709, no clamp. Counts pixels that are, with their eight neighbours, in the image and not
/// masked. Nothing when fewer than 100 of them lie at an edge.
std::optional<EdgeBlur> edge_blur(const PairSamples& samples);

MetricResult compute_edge_blur(const ImagePair& pair);

/// "its edges are softer than the reference's by 0.4 (0.3 to 0.5), at most 0.2 is allowed".
std::string describe_edge_blur(const Measurement& measurement, const Limits& limits);

inline constexpr MetricInfo kEdgeBlur{
    "edge_blur",
    "1",
    Better::NearZero,
    "sum of (result - reference) in the direction of change over sum |change|, where change is the "
    "reference filtered by [1 2 1] / 4 in x and y less the reference: 1 is as soft as that filter, below 0 "
    "sharper; over unmasked pixels and channels where |change| is above 5 % of filtered reference and its "
    "mean together, each divided by these, and above five standard deviations; linear Rec.709, no clamp. "
    "The interval is three standard errors, or Student's "
    "where the image is looked at several times",
    kNoMap,
    compute_edge_blur,
    Computed::Always,
    GateRule::AnyOfInterval,
    describe_edge_blur};

}  // namespace orbs::metrics
