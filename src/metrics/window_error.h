#pragma once

#include "metrics/pair_samples.h"

#include <array>
#include <optional>

namespace orbs::metrics {

/// The largest error of the mean over any square window of the image that is there for certain: a leak, a
/// missing patch, a wrong texture in one place.
///
/// Of a window and channel it is |mean(result - reference)|, less
/// - the reach of Student's interval, which leaves out a right image in one of 10,000 over all windows of one
///   size together (Bonferroni), with the noise and its degrees of freedom as in noise_test.h; of a window
///   that is too dark the light that its samples may have missed (rare_light.h), where that is more;
/// - what edges make that lie 0.05 px from where they lie in the reference: 0.05 times the steps of the
///   reference to its neighbours. Antialiasing on a grid and rounded vertices move edges that much.
///
/// It is relative to the light around it: over 16 and 64 px to the reference's mean over the window and
/// channel, at least a tenth of the image's mean (nobody sees it below); over 8 px, where a leak into the
/// dark is meant, at least the image's mean.
struct WindowError {
  double value = 0;  // 0: no window is off for certain
  Rectangle where;   // the worst, the first by rows
  /// What an error over any window may be at most, within kErrorsToPass; relative to the
  /// window's mean of the reference, at least half of what is bright in the image (the 95th percentile),
  /// because what hides an error of the dark hides nothing that anybody sees. What the noise of the reference
  /// hides does not count: no samples of the result show it. 0 with one look, and for the smallest windows,
  /// which are too many.
  double largest = 0;
};

/// An error that a gate of windows promises to find must be certain to so much of its size: the limit is this
/// share of the promised one.
inline constexpr double kCertainShare = 0.6;

/// Sides of the windows.
inline constexpr std::array kWindows_px{8, 16, 64};

/// Nothing for a size that the image has no window of, and where the reference's mean is not above ten times
/// its own noise (black, or a difference of images).
using WindowErrors = std::array<std::optional<WindowError>, kWindows_px.size()>;

/// The windows lie an eighth of their side apart, so that an error of their size is met to 15 sixteenths of
/// its width and height at least. Of a window at least half of the pixels count.
WindowErrors window_errors(const PairSamples& samples);

}  // namespace orbs::metrics
