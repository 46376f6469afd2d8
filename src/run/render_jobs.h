#pragma once

#include "results/record.h"
#include "run/execute.h"
#include "run/plan/plan.h"
#include "run/program_hash.h"

#include <atomic>
#include <functional>
#include <string>
#include <vector>

namespace orbs::run {

/// Called after each render that was not skipped, one at a time: how many are done, of how many, the render,
/// and the images judged from it.
using Progress = std::function<void(
    std::size_t, std::size_t, const results::JobRecord&, const std::vector<results::TargetRecord>&)>;

/// Called when a render starts, one at a time.
using Started = std::function<void(const results::JobIdentity&)>;

struct RenderContext {
  std::string orbs_version;
  std::string day{};  // of the run's start, "2026-11-25", by which known failures expire; run() sets it
  const std::atomic<bool>* stop = nullptr;  // set when the user interrupts
  Started started = {};
  Progress progress;                                 // not called for jobs that an earlier run has finished
  std::function<void(const std::string&)> say = {};  // why something is rendered again
};

/// A job, and the targets that are judged from its render alone.
struct JudgedJob {
  results::JobRecord job;
  std::vector<results::TargetRecord> targets;
};

/// Renders and judges each job that is not in the run's folder yet or is outdated there; a job that only has
/// another reference or gate now is judged again. Each job's folder is renamed into place when it is
/// complete. One result for each job of the plan. WriteError when the disk refuses: the jobs that are in
/// place by then stay.
std::vector<JudgedJob> render_jobs(const Plan& plan,
                                   const std::vector<std::string>& versions,
                                   const WorkFolders& folders,
                                   const RenderContext& context,
                                   ProgramWatch& programs);

}  // namespace orbs::run
