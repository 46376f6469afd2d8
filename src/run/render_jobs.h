#pragma once

#include "results/record.h"
#include "run/execute.h"
#include "run/plan/plan.h"
#include "run/program_hash.h"
#include "run/render_context.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace orbs::run {

struct RenderedJobs {
  std::vector<JudgedJob> jobs;                                 // one for each of the plan
  std::map<std::size_t, results::TargetRecord> differences{};  // by target: those that looks have judged
};

/// Renders and judges each job that is not in the run's folder yet or is outdated there; a job that only has
/// another reference or gate now is judged again. Jobs in looks get samples until their targets are decided,
/// see looks.h. Each job's folder is renamed into place when a render, or a look, is complete. WriteError
/// when the disk refuses: what is in place by then stays.
RenderedJobs render_jobs(const Plan& plan,
                         const std::vector<std::string>& versions,
                         const WorkFolders& folders,
                         const RenderContext& context,
                         ProgramWatch& programs);

}  // namespace orbs::run
