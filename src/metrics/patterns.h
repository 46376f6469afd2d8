#pragma once

#include "metrics/pair_samples.h"

#include <string>
#include <string_view>
#include <vector>

namespace orbs::metrics {

/// What a pattern's amplitude is measured in.
enum class AmplitudeUnit { Percent, Pixels, Degrees };

/// A kind of mistake whose errors are known up to their size: result - reference = amplitude * pattern. The
/// sum over the image finds amplitudes that are lost in the noise of every block.
struct Pattern {
  std::string_view more;  // what the image is where the amplitude is above zero
  std::string_view less;
  AmplitudeUnit unit = AmplitudeUnit::Percent;
  double negligible = 0;  // an amplitude that is never called an error
  /// An amplitude that no right renderer has: more than this for certain fails. About 0.6 of what
  /// docs/understand/verdicts.md promises to refuse, so that noise may hide 0.4 of it.
  double most = 0;
  /// Where `most` is 0: that amplitude which moves the middle of an edge of the image by so much.
  double most_at_edge_px = 0;
  double largest = 1;  // beyond it the pattern, a fault's first order, is no longer what the fault does
  /// What the image is below an amplitude of -1, where `largest` allows that: a fit can take more than all of
  /// the light, and nothing is darker by more than 100 %.
  std::string_view beyond_all = "";
};

struct PatternFinding {
  const Pattern* pattern = nullptr;
  double amplitude = 0;
  double low = 0;  // ends of its interval
  double high = 0;
  double z = 0;       // amplitude over its standard deviation
  double excess = 0;  // what of the amplitude is certain, over the most that is allowed
};

/// The patterns that stand out from the noise by more than what is negligible: gradients, contrast, shadows,
/// highlights, black level, saturation, hue, shifts, rotation, scale, sharpness, gamma, stripes and
/// checkerboard. That which stands out most comes first. `false_alarms` is the probability that a right image
/// has one.
///
/// The standard deviation by which they are found is that of the sums of 8 x 8 px blocks, whose mean is zero
/// where only noise is left; so the noise need not be known, and may be shared by neighbouring pixels. Such a
/// self-normalised sum has tails below those of Student's distribution even where the noise has not (B.
/// Efron, "Student's t-test under symmetry conditions", J. Am. Stat. Assoc. 64, 1969).
std::vector<PatternFinding> find_patterns(const PairSamples& samples, double false_alarms);

/// Whether the whole interval lies where the pattern describes its fault. A mirrored image is no image "of a
/// lower gamma by 68.7 % (5.65 to 132)", however well that fits.
bool is_within_range(const PatternFinding& finding);

/// "shifted to the right by 0.25 px (0.22 to 0.27)".
std::string describe(const PatternFinding& finding);

}  // namespace orbs::metrics
