#pragma once

#include "studies/cost/curve.h"

#include <cstddef>
#include <vector>

namespace orbs::studies {

/// The renders of a ladder that were made for `purpose`; of one rung where `rung` names one.
std::vector<const CostRender*> renders_of(const CostRecord& record,
                                          const CostLadder& ladder,
                                          const char* purpose,
                                          const std::string& rung = "");

/// The curve of the ladder with this index: its points, its noise and its fit. Its prices and the frontier
/// are missing still.
CostCurve cost_curve(const CostRecord& record, std::size_t index);

/// The point's median CPU time above the fixed cost; nothing where it is not above it.
std::optional<double> seconds_above_fixed(const CostCurve& curve, const CostPoint& point);

}  // namespace orbs::studies
