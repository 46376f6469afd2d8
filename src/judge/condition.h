#pragma once

#include "judge/gate_result.h"
#include "registry/case.h"
#include "results/record.h"

#include <optional>

namespace orbs::judge {

/// The name of the check.
inline constexpr const char* kConditionCheck = "condition_map";

/// Whether rounding decides no more in the scene than its case allows: Fail above the bound, Inconclusive
/// where the two renders could not be made, with the check and the number in the record. Nothing where all is
/// well, and where the renderer was not asked.
std::optional<GateResult> check_condition(const registry::ConditionBound& bound,
                                          const results::JobCondition& condition,
                                          results::TargetRecord& record);

}  // namespace orbs::judge
