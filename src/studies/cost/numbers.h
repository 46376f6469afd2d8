#pragma once

#include "studies/cost/curve.h"
#include "studies/cost/record.h"

#include <optional>
#include <vector>

namespace orbs::studies {

/// What follows from the renders of a study of cost. Nothing of it is stored, as it can be computed anew.
struct CostNumbers {
  std::vector<CostCurve> curves;  // by ladder
  std::optional<SelfComparison> self_comparison;
  /// Only where the comparison of a renderer with itself passed.
  std::vector<CostComparison> comparisons;
};

CostNumbers cost_numbers(const CostRecord& record);

}  // namespace orbs::studies
