#pragma once

#include "base/process_limits.h"
#include "run/plan/plan.h"

namespace orbs::run {

/// The limits of the job's renderer, with the shorter of its time limit and that of the scene's case.
ProcessLimits limits_of(const Plan& plan, const PlannedJob& job);

}  // namespace orbs::run
