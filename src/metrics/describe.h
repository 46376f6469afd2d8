#pragma once

#include "metrics/metric.h"

#include <string>

namespace orbs::metrics {

/// Whether `value` keeps the limits; NaN keeps none.
bool is_within(double value, const Limits& limits);

/// "at most 0.2 is allowed": what a gate allows, each limit times `scale` and followed by `unit`. Limits that
/// lie symmetrically about zero are stated as one.
std::string limits_text(const Limits& limits, double scale = 1, const std::string& unit = "");

/// What a verdict says of a number that a gate looks at: "psnr_srgb8 is 31.2 dB, at least 35 is needed", in
/// the metric's own words where it has some.
std::string describe(const Measurement& measurement, const Limits& limits);

}  // namespace orbs::metrics
