#pragma once

#include "metrics/pair_samples.h"

namespace orbs::metrics {

/// How far the coverage is off at edges. The unit is what one sample a pixel makes there.
struct CoverageEdges {
  double error = 0;    // mean square
  double certain = 0;  // what is left of it beyond what is allowed
};

/// The sum of the squared differences over that of c (1 - c), which one random sample a pixel has, or over a
/// sixth of the edges' length in pixels where that is larger: over all places of a straight edge the mean of
/// c (1 - c) is 1 / 6. The middle of each pixel makes 1/2 (a coverage of 0 and 1 alone), an edge that is
/// moved by half a pixel 5/4, by a fifth of one 0.22; a tent filter, two pixels wide, 0.05 to 0.19.
///
/// Allowed is 1/4, that of four samples a pixel and of a fifth of a pixel, and what the noise of the samples
/// reaches: eight, as many as each of the two renders of a first look has, or half of `samples.spp`
/// where that is known to be less.
CoverageEdges coverage_edges(const PairSamples& samples, const LayerChannel& coverage, double false_alarms);

}  // namespace orbs::metrics
