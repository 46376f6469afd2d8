#pragma once

#include "studies/cost/curve.h"

#include <string>
#include <vector>

namespace orbs::studies {

/// The errors to which times are stated: 30, 35, 40 and 45 dB, relmse 1e-2, 1e-3 and 1e-4.
const std::vector<ErrorTarget>& error_targets();

/// "35 dB", "relMSE 1e-3".
std::string error_text(const ErrorTarget& target);

/// The time to an error on a curve with its points; `has_samples` says whether there is something between two
/// settings.
TimeToError time_to_error(const CostCurve& curve, const ErrorTarget& target, bool has_samples);

/// Fills the curve's times to error, its efficiency and what one more decibel takes.
void set_times_to_error(CostCurve& curve, bool has_samples);

}  // namespace orbs::studies
