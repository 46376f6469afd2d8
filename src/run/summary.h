#pragma once

#include "results/record.h"
#include "run/plan/plan.h"

#include <string>
#include <vector>

namespace orbs::run {

/// Fills requirements and renderers of the record anew from its images and jobs.
void summarise(const Plan& plan, const std::vector<std::string>& versions, results::RunRecord& record);

/// The same for a record that knows its cases and renderers already.
void summarise(results::RunRecord& record);

/// The requirements that a renderer fulfils, those whose cell is a pass, in ORB.S notation. What the run does
/// not decide (inconclusive, skipped, without a reference) follows each group: "G3?(2)" when G1 and G3 pass
/// and G2 is open, "G?" when nothing of G is decided. Groups that the run did not test are left out.
std::string measured_features(const std::vector<results::RequirementRecord>& requirements,
                              const std::string& renderer);

}  // namespace orbs::run
