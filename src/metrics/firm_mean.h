#pragma once

#include "metrics/pair_samples.h"

#include <optional>

namespace orbs::metrics {

/// Mean of the reference over R, G and B of the counted pixels; nothing where noise could make it: where it
/// is not above ten times its own noise, as in black images and in differences of images.
std::optional<double> firm_mean(const PairSamples& samples);

}  // namespace orbs::metrics
