#pragma once

#include "results/record.h"
#include "runner/plan.h"

#include <atomic>
#include <functional>
#include <string>
#include <vector>

namespace orbs::runner {

/// Called after each render, one at a time: how many are done, of how many, the render, and the pictures
/// judged from it.
using Progress = std::function<void(
    std::size_t, std::size_t, const results::JobRecord&, const std::vector<results::PictureRecord>&)>;

struct RunContext {
  std::string orbs_version;
  std::vector<std::string> command_line;
  const std::atomic<bool>* stop = nullptr;  // set when the user wants no more
  Progress progress;
};

/// Makes the folder of a run: `wanted`, which must not exist or be empty, or "" for outputs-YYMMDD-HHMMSS
/// (local time) in the current folder, with -2, -3, ... behind it where that is taken. Returns the absolute
/// path.
std::filesystem::path make_run_folder(const std::string& wanted);

/// Carries out the plan in `folder`: leaves there results.json of what will be rendered and the references,
/// renders, judges, and leaves in each job's folder the scene, result.exr, log.txt, job.json and the error
/// maps. Ends with the final results.json. What a renderer does wrong is in the record; InputError only when
/// we cannot write.
results::RunRecord run(const Plan& plan, const std::filesystem::path& folder, const RunContext& context);

}  // namespace orbs::runner
