#include "run/plan/job_limits.h"

#include <algorithm>

namespace orbs::run {

ProcessLimits limits_of(const Plan& plan, const PlannedJob& job) {
  auto limits = plan.renderers[job.renderer].entry.limits;
  if (const double seconds = plan.scenes[job.scene].wall_seconds; seconds > 0)
    limits.wall_seconds = std::min(limits.wall_seconds, seconds);
  return limits;
}

}  // namespace orbs::run
