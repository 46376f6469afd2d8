#pragma once

#include "results/record.h"
#include "runner/plan.h"
#include "runner/run_file.h"

#include <atomic>
#include <functional>
#include <string>
#include <vector>

namespace orbs::runner {

/// Called after each render, one at a time: how many are done, of how many, the render, and the images
/// judged from it.
using Progress = std::function<void(
    std::size_t, std::size_t, const results::JobRecord&, const std::vector<results::TargetRecord>&)>;

struct RunContext {
  std::string orbs_version;
  std::vector<std::string> command_line;
  const std::atomic<bool>* stop = nullptr;           // set when the user wants no more
  RunFile file;                                      // written into the folder once it is ours
  Progress progress;                                 // not called for what is there already
  std::function<void(const std::string&)> say = {};  // why something is rendered again
};

/// Carries out the plan in `folder`: leaves there results.json of what will be rendered and the references,
/// renders, judges, and leaves in each job's folder the scene, result.exr, log.txt, job.json and the error
/// maps. Ends with the final results.json. What is there already and not outdated is kept as it is: the same
/// call resumes a run that was killed, and only writes results.json anew for one that was finished. What a
/// renderer does wrong is in the record; InputError when another process has the folder, WriteError when the
/// disk refuses.
results::RunRecord run(const Plan& plan, const std::filesystem::path& folder, const RunContext& context);

}  // namespace orbs::runner
