#pragma once

#include "studies/cost/curve.h"

namespace orbs::studies {

/// The price of a goal on a curve with its points; `has_samples` says whether there is something between two
/// rungs.
CostPrice cost_price(const CostCurve& curve, const CostGoal& goal, bool has_samples);

/// Fills the curve's prices, its efficiency and what one more decibel costs.
void set_prices(CostCurve& curve, bool has_samples);

}  // namespace orbs::studies
