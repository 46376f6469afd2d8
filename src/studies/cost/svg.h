#pragma once

#include "studies/cost/record.h"

#include <string>

namespace orbs::studies {

/// An SVG image of all curves for documents: one small chart per target, relMSE against CPU seconds, both
/// logarithmic and with the same axes in all charts. A bar through a point is the 95 % interval of its error;
/// a hollow point is below the noise of the reference; a dashed line is a floor.
std::string cost_svg(const CostRecord& record);

}  // namespace orbs::studies
