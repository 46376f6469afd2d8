#pragma once

#include "metrics/metric.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace orbs::metrics {

/// How the Stokes parameters of the result follow from the reference's over the whole image: 0.95 times S1,
/// or a frame that is turned by 2 degrees, is lost in the noise of every block.
///
/// All are quotients of sums of ring x result and ring x reference, with the mean of the reference over the 8
/// neighbours of each pixel, whose noise is in neither. Their noise is what they leave of each block, so that
/// it needs no variances, and blocks of pixels whose noise is not independent tell it, too.
struct StokesNumber {
  double value = 0;
  double standard_error = 0;
  double degrees = 1;    // of freedom of the standard error
  double in_common = 0;  // reach of the noise that all pixels share, and of light that no sample has found
  double reference_share = 0;  // of the variance, which no samples of the result make less
};

/// What is known of the three scales and the turn. A parameter has no scale where the reference's is less
/// than kLeastShare of the light, or does not stand out from its noise; `share` says how much it is.
struct StokesScales {
  std::array<std::optional<StokesNumber>, 3> scale;  // value 1: as the reference's
  std::array<double, 3> share{};  // root mean square of the reference's parameter over its mean luminance
  std::optional<StokesNumber> turn_deg;  // counter-clockwise, of the polarisation in the image
};

/// Of less no render at a reasonable cost tells the sign.
constexpr double kLeastShare = 0.005;

/// Nothing where one of the images has no Stokes parameters, or the reference is black. A turn below 22.5
/// degrees that is certain is undone before the scales are read, as it moves S1 and S2 into each other.
std::optional<StokesScales> stokes_scales(const PairSamples& samples);

namespace stokes_scale {

MetricResult compute(const ImagePair& pair, std::size_t parameter);

template <std::size_t Parameter>
MetricResult compute_one(const ImagePair& pair) {
  return compute(pair, Parameter);
}

/// "S1 is 5 % too small (4.6 to 5.4 %), at most 3 % is allowed", "S3 has the other sign …".
std::string describe(const Measurement& measurement, const Limits& limits);

template <std::size_t Parameter>
constexpr MetricInfo row(std::string_view name) {
  return {
      name,
      "1",
      Better::NearZero,
      "factor - 1 by which a Stokes parameter is off over the unmasked pixels: sum(ring x result) / "
      "sum(ring x reference), with the reference's mean over the 8 neighbours of each pixel; linear "
      "Rec.709 luminance, no clamp. A turn of the frame below 22.5 degrees is undone first. No value where "
      "the parameter is below 0.5 % of the light. The interval is that of what the factor leaves of each "
      "block, by Student's distribution",
      kNoMap,
      compute_one<Parameter>,
      Computed::Always,
      GateRule::WholeInterval,
      describe};
}

}  // namespace stokes_scale

inline constexpr MetricInfo kStokesScale1 = stokes_scale::row<0>("stokes_scale_s1");
inline constexpr MetricInfo kStokesScale2 = stokes_scale::row<1>("stokes_scale_s2");
inline constexpr MetricInfo kStokesScale3 = stokes_scale::row<2>("stokes_scale_s3");

MetricResult compute_stokes_turn(const ImagePair& pair);

/// "its frame is turned by 2 degrees (1.9 to 2.1), at most 1 is allowed".
std::string describe_stokes_turn(const Measurement& measurement, const Limits& limits);

inline constexpr MetricInfo kStokesTurn{
    "stokes_turn",
    "degrees",
    Better::NearZero,
    "half the angle by which S1 and S2 of the reference, taken as one complex number, must be turned to those "
    "of the result: the argument of sum(conj(ring) x result) over that of sum(conj(ring) x reference), over "
    "the unmasked pixels, with the reference's mean over the 8 neighbours of each pixel; linear Rec.709 "
    "luminance, no clamp. The interval is that of what the turn leaves of each block, by Student's distribution",
    kNoMap,
    compute_stokes_turn,
    Computed::Always,
    GateRule::WholeInterval,
    describe_stokes_turn};

}  // namespace orbs::metrics
