#pragma once

#include "base/statistics.h"
#include "metrics/metric.h"
#include "metrics/noise_test.h"

#include <string>
#include <vector>

namespace orbs::metrics {

/// Whether `value` keeps the limits; NaN keeps none.
bool is_within(double value, const Limits& limits);

/// "at most 0.2 is allowed": what a gate allows, each limit times `scale` and followed by `unit`. Limits that
/// lie symmetrically about zero are stated as one.
std::string limits_text(const Limits& limits, double scale = 1, const std::string& unit = "");

/// What a verdict says of a number that a gate looks at: "psnr_srgb8 is 31.2 dB, at least 35 is needed", in
/// the metric's own words where it has some.
std::string describe(const Measurement& measurement, const Limits& limits);

/// A relative deviation of light in words: "1.2 % darker (0.9 to 1.5 %)". An end of the interval on the other
/// side of zero keeps its word: "0.1 % darker (0.7 % darker to 0.5 % brighter)".
std::string lightness_text(const Interval& deviation);

/// What the tests see beyond noise, one text each, the plainest first; empty for an image that is only noisy.
/// A reader must be told this of an image that passes, too. The squares count where
/// nothing else is said and they are more than antialiasing makes at the edges of objects.
std::vector<std::string> bias_remarks(const NoiseTest& test);

/// The first of the remarks, or else the squares. "" when no test sees a bias.
std::string bias_message(const NoiseTest& test);

/// What noise hides: "noise hides errors below 7 % over 16 x 16 px", where an error of 2 % over 64 x 64 px or
/// of 5 % over 16 x 16 px would not be found in nine of ten places. "" where they would be.
std::string hidden_by_noise(const NoiseTest& test);

}  // namespace orbs::metrics
