#pragma once

#include "metrics/noise_test.h"

#include <string>

namespace orbs::metrics {

/// That the means, or else the blocks, differ by more than noise: a reader must be told this of an image that
/// passes, too. "" when they do not. Images of two correct renderers differ at the edges of objects, so the
/// squares are left out here.
std::string bias_remark(const NoiseTest& test);

/// The bias that is_biased sees: the remark, or else the squares. "" when it sees none.
std::string bias_message(const NoiseTest& test);

}  // namespace orbs::metrics
