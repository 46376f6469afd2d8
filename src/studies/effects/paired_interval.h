#pragma once

#include "base/statistics.h"

#include <optional>
#include <vector>

namespace orbs::studies {

/// The 95 % interval of the geometric mean of ratios of paired times; nothing if one of them is no ratio.
std::optional<Interval> paired_interval(const std::vector<double>& ratios);

}  // namespace orbs::studies
