#pragma once

#include "results/record.h"
#include "run/plan/plan.h"
#include "run/plan/plan_file.h"
#include "run/render_jobs.h"
#include "run/run_file.h"

#include <filesystem>
#include <string>
#include <vector>

namespace orbs::run {

struct RunContext {
  std::vector<std::string> command_line;
  RunFile file;          // written into the folder once it is ours
  FiledPlan whole_plan;  // of which the plan may be a shard; likewise
  RenderContext rendering;
};

/// Carries out the plan in `folder`: writes a results.json of what will be rendered and copies the
/// references, renders and judges, leaves in each job's folder the scene, result.exr, log.txt, job.json and
/// the error maps, and writes the final results.json. Jobs that are complete and not outdated are kept: the
/// same call resumes a run that was killed, and only writes results.json anew for one that was finished.
/// Faults of a renderer are outcomes in the record; InputError when another process has the folder,
/// WriteError when the disk refuses.
results::RunRecord run(const Plan& plan, const std::filesystem::path& folder, const RunContext& context);

}  // namespace orbs::run
