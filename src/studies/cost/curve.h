#pragma once

#include "studies/cost/numbers.h"

#include <cstddef>
#include <string>
#include <vector>

/// The steps from the renders of a sweep to its curve, for the files of this folder.
namespace orbs::studies {

/// The renders of a sweep that were made for `purpose`; of one setting where `setting` names one.
std::vector<const CostRender*> renders_of(const CostRecord& record,
                                          const Sweep& sweep,
                                          Purpose purpose,
                                          const std::string& setting = "");

/// The curve of the sweep with this index: its points, its noise and its fit. Its times to error and the
/// frontier are missing still.
CostCurve cost_curve(const CostRecord& record, std::size_t index);

/// CPU seconds of the fixed cost; 0 if it was not measured.
double fixed_seconds(const CostCurve& curve);

/// The point's median CPU time above the fixed cost; nothing where it is not above it.
std::optional<double> seconds_above_fixed(const CostCurve& curve, const CostPoint& point);

/// The time to an error on a curve with its points; `has_samples` says whether there is something between two
/// settings.
TimeToError time_to_error(const CostCurve& curve, const ErrorTarget& target, bool has_samples);

/// Fills the curve's times to error, its efficiency and what one more decibel takes.
void set_times_to_error(CostCurve& curve, bool has_samples);

}  // namespace orbs::studies
