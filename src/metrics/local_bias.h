#pragma once

#include "metrics/metric.h"

#include <optional>
#include <string>

namespace orbs::metrics {

/// Where an image is off by more than noise over tiles of 16 x 16 px: the size of a lost detail, a leak or a
/// shadow that is not there, which the mean of a whole image does not show.
///
/// |sum(result - reference)| - 5 standard errors, over reference tile + reference image (means, so that a
/// dark tile is measured by what is visible beside it). The standard error is that of the tile's own pixels:
/// it needs no variance channel, and an error with structure within a tile only makes it larger. Five, as an
/// image has thousands of tiles: one in some hundred control images would show a tile above 0, and the
/// tolerance is far from 0. An image that is looked at several times has Student's quantile in its place, for
/// all looks, tiles and channels together, and at least the noise that its number of samples makes.
struct LocalBias {
  double value = 0;  // 0: no tile is off for sure
  Rectangle where;   // the worst tile, the first by rows
  /// What a tile may be off by, at most, but for kWrongPasses over all looks; with one look it is not needed.
  double largest = 0;
};

/// The worst of R, G, B and all tiles from the upper left corner; tiles with fewer than 64 unmasked pixels
/// are left out. Nothing when none is left, or when the reference's mean is not above 0 in any channel.
std::optional<LocalBias> local_bias(const PairSamples& samples);

MetricResult compute_local_bias(const ImagePair& pair);

/// "the mean of the tile [16,0,32,16] is off by 12 % or more for sure, at most 10 % is allowed".
std::string describe_local_bias(const Measurement& measurement, const Limits& limits);

inline constexpr MetricInfo kLocalBias{
    "local_bias",
    "1",
    Better::Lower,
    "the largest |mean(result) - mean(reference)| of the unmasked pixels of a tile of 16 x 16 px, less five "
    "standard errors of the tile's own pixels (of several looks: Student's), over the reference's means of tile and image together; of R, "
    "G and B the worst; linear Rec.709, no clamp",
    kNoMap,
    compute_local_bias,
    Computed::Always,
    GateRule::Certain,
    describe_local_bias};

}  // namespace orbs::metrics
