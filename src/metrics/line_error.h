#pragma once

#include "metrics/pair_samples.h"

#include <optional>

namespace orbs::metrics {

/// The largest error that is there for certain along any line of the image that is one pixel wide: rays
/// through a shared edge of two triangles that miss both, a row or a column that is lost, a seam between
/// tiles. A window of 8 px is off by an eighth of it at most.
///
/// The sums over lines are those of the approximate discrete Radon transform (Brady 1998; Goetz and Druck
/// 1996): a line over 2k rows is one over k rows and one of the same slope over the k rows below it. So the
/// sums over all lines of 16, 32, 64 ... pixels of every slope cost n log n, and a line that is curved is met
/// by the short ones.
///
/// Of a line and channel it is |mean(result - reference)|, less the reach of Student's interval, which leaves
/// out a right image in one of 10,000 over all lines together (Bonferroni), and less what edges make that lie
/// 0.2 px from where they lie in the reference; a line may lie along an edge, where antialiasing on a grid
/// does that. It is relative to the larger of the reference's means of line and image.
struct LineError {
  double value = 0;  // 0: no line is off for certain
  Rectangle where;   // around the worst
};

/// Nothing where the reference's mean is not above ten times its own noise, or no line of 16 px fits in.
std::optional<LineError> line_error(const PairSamples& samples);

}  // namespace orbs::metrics
