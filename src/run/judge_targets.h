#pragma once

#include "judge/judge.h"
#include "results/record.h"
#include "run/execute.h"
#include "run/plan/plan.h"

#include <cstddef>
#include <filesystem>
#include <vector>

/// From renders to the records of targets.
namespace orbs::run {

/// Where a run keeps its copies of the references.
inline constexpr const char* kReferenceFolder = "references";

/// The record of a target before its renders are judged. `folder` is the run's.
results::TargetRecord blank_target(const Plan& plan,
                                   const PlannedTarget& planned,
                                   const std::filesystem::path& folder);

/// The record of a target that is not rendered: its renderer does not declare the requirement, or cannot be
/// measured at the size of the run.
results::TargetRecord unsupported_target(const Plan& plan,
                                         const PlannedTarget& planned,
                                         const std::filesystem::path& folder);

/// The outcome of the render becomes the verdict of its target.
void take_job_verdict(const results::JobRecord& job, results::TargetRecord& record);

struct JudgedTarget {
  results::TargetRecord record;
  judge::Look look = {};  // closed where the samples are fixed
};

/// All targets that are judged from this render alone, one for each case that judges it; their maps lie in
/// the render's unfinished folder.
std::vector<JudgedTarget> judge_scene(const Plan& plan,
                                      std::size_t job,
                                      const Execution& execution,
                                      const WorkFolders& folders);

/// A difference of two renders, `of` and `minus`, that are in their places; its own folder is put into its
/// place.
JudgedTarget judge_difference(const Plan& plan,
                              const PlannedTarget& planned,
                              const std::vector<const results::JobRecord*>& jobs,
                              const WorkFolders& folders);

}  // namespace orbs::run
