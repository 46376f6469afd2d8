#pragma once

#include "studies/cost/curve.h"

#include <optional>
#include <vector>

namespace orbs::studies {

/// The renders of the rung that was rendered again, against those of the rung: the same renderer under two
/// names. Nothing while there are less than two of each.
std::optional<SelfComparison> compare_with_itself(const CostRecord& record);

/// Every two renderers at every goal of every target that both were measured on.
std::vector<CostComparison> compare_renderers(const CostRecord& record, const std::vector<CostCurve>& curves);

}  // namespace orbs::studies
