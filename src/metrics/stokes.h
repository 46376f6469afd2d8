#pragma once

#include "metrics/metric.h"

#include <optional>
#include <string>

namespace orbs::metrics {

/// Root mean square, over S1 to S3 and the blocks of 8 x 8 px, of the difference of the block means in
/// Rec.709 luminance, over the reference's mean luminance. Block means, because single pixels are mostly
/// noise: half of unpolarised light is in each of these differences. Nothing where one of the images has no
/// Stokes parameters or the reference is black. Masked pixels do not count.
std::optional<double> stokes_error(const PairSamples& samples);

/// By which factor one Stokes parameter of the result is off, over the whole image: 0.95 times S1 is lost in
/// the noise of every block. The factor is sum(ring x result) / sum(ring x reference), with the mean of the
/// reference over the 8 neighbours of each pixel, whose noise is in neither of the two.
struct StokesScale {
  int parameter = 1;  // of S1, S2 and S3
  double ratio = 1;
  double certain =
      0;  // |ratio - 1| less the reach of its noise, which leaves out a right image in 1 of 10,000
};

/// The one that is off most for certain. Nothing where one of the images has no Stokes parameters, or where
/// those of the reference stand out from their noise nowhere.
std::optional<StokesScale> stokes_scale(const PairSamples& samples);

MetricResult compute_stokes_error(const ImagePair& pair);

MetricResult compute_stokes_scale_error(const ImagePair& pair);

/// "S1 is 0.95 times what it should be, 4.2 % off or more for certain, at most 3 % is allowed".
std::string describe_stokes_scale_error(const Measurement& measurement, const Limits& limits);

/// "its Stokes parameters are off by 3 % of the light, at most 2 % is allowed".
std::string describe_stokes_error(const Measurement& measurement, const Limits& limits);

inline constexpr MetricInfo kStokesError{
    "stokes_error",
    "1",
    Better::Lower,
    "root mean square over S1, S2, S3 and blocks of 8 x 8 px of mean(result) - mean(reference) of the unmasked "
    "pixels in linear Rec.709 luminance, over the reference's mean luminance; no clamp",
    kNoMap,
    compute_stokes_error,
    Computed::Always,
    GateRule::Value,
    describe_stokes_error};

inline constexpr MetricInfo kStokesScaleError{
    "stokes_scale_error",
    "1",
    Better::Lower,
    "the largest |factor - 1| by which S1, S2 or S3 of the unmasked pixels is off over the whole image, less the "
    "reach of its noise: sum(ring x result) / sum(ring x reference), with the reference's mean over the 8 "
    "neighbours of each pixel; linear Rec.709 luminance, no clamp",
    kNoMap,
    compute_stokes_scale_error,
    Computed::Always,
    GateRule::Certain,
    describe_stokes_scale_error};

}  // namespace orbs::metrics
