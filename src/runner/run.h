#pragma once

#include "results/record.h"
#include "runner/plan.h"
#include "runner/render_jobs.h"
#include "runner/run_file.h"

#include <filesystem>
#include <string>
#include <vector>

namespace orbs::runner {

struct RunContext {
  std::vector<std::string> command_line;
  RunFile file;  // written into the folder once it is ours
  RenderContext rendering;
};

/// Carries out the plan in `folder`: leaves there results.json of what will be rendered and the references,
/// renders, judges, and leaves in each job's folder the scene, result.exr, log.txt, job.json and the error
/// maps. Ends with the final results.json. What is there already and not outdated is kept as it is: the same
/// call resumes a run that was killed, and only writes results.json anew for one that was finished. What a
/// renderer does wrong is in the record; InputError when another process has the folder, WriteError when the
/// disk refuses.
results::RunRecord run(const Plan& plan, const std::filesystem::path& folder, const RunContext& context);

}  // namespace orbs::runner
