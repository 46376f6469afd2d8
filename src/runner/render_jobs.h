#pragma once

#include "results/record.h"
#include "runner/execute.h"
#include "runner/plan.h"
#include "runner/run.h"

#include <string>
#include <vector>

namespace orbs::runner {

/// All renders of a plan and the images judged from each, by job.
struct Work {
  std::vector<results::JobRecord> jobs;
  std::vector<std::vector<results::TargetRecord>> targets;
};

/// Renders and judges what is not in the run's folder yet or is there but outdated; what only has another
/// reference or gate now is judged again. Each render's folder takes its place when it is whole. WriteError
/// when the disk refuses: what is in its place by then stays.
Work render_jobs(const Plan& plan,
                 const std::vector<std::string>& versions,
                 const WorkFolders& folders,
                 const RunContext& context);

}  // namespace orbs::runner
