#pragma once

/// Changes of an image's numbers that are too small to be called a change, however certain they are: one
/// number for the comparison of two runs and for that of a failure with the accepted one.
namespace orbs::results {

/// Of the mean of a channel, relative to the reference. Rounding and other compilers stay far below.
inline constexpr double kLeastLight = 0.001;
/// Of an error, as a share of it.
inline constexpr double kLeastError = 0.05;

}  // namespace orbs::results
