#pragma once

#include "metrics/metric.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace orbs::metrics {

/// Rec.709 luminance of a pixel of interleaved R, G, B.
double luminance_at(const std::vector<float>& rgb, std::size_t pixel);

/// Root mean square, over S1 to S3 and the blocks of 8 x 8 px, of the difference of the block means in
/// Rec.709 luminance, over the reference's mean luminance. Block means, because single pixels are mostly
/// noise: half of unpolarised light is in each of these differences. Nothing where one of the images has no
/// Stokes parameters or the reference is black. Masked pixels do not count.
std::optional<double> stokes_error(const PairSamples& samples);

MetricResult compute_stokes_error(const ImagePair& pair);

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

}  // namespace orbs::metrics
