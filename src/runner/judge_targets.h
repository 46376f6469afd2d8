#pragma once

#include "results/record.h"
#include "runner/execute.h"
#include "runner/judge.h"
#include "runner/plan.h"

#include <filesystem>
#include <optional>
#include <vector>

/// From renders to records of images.
namespace orbs::runner {

/// Where a run keeps its copies of the references.
inline constexpr const char* kReferenceFolder = "references";

/// The record of an image that nothing is known about yet. `folder` is the run's.
results::TargetRecord blank_target(const Plan& plan,
                                   const PlannedTarget& planned,
                                   const std::filesystem::path& folder);

/// Of an image that is not rendered because its renderer does not declare the requirement.
results::TargetRecord undeclared_target(const Plan& plan,
                                        const PlannedTarget& planned,
                                        const std::filesystem::path& folder);

/// What is said about an image with usable pixels: negative values, the gate and all conditions of the case,
/// and whether it is of one colour. Returns the comparison, for its maps; nothing when there was none.
std::optional<metrics::Comparison> judge_values(const registry::Case& one_case,
                                                const image::Image& result,
                                                const Reference& reference,
                                                const JudgeSettings& settings,
                                                results::TargetRecord& record);

/// What became of the render is what there is to say about its image.
void take_job_verdict(const results::JobRecord& job, results::TargetRecord& record);

/// All images that this render alone makes, one for each case that looks at it; their maps lie in its
/// unfinished folder.
std::vector<results::TargetRecord> judge_scene(const Plan& plan,
                                               std::size_t job,
                                               const Execution& execution,
                                               const WorkFolders& folders);

/// A difference of two renders that are in their places; its folder takes its own.
results::TargetRecord judge_difference(const Plan& plan,
                                       const PlannedTarget& planned,
                                       const std::vector<results::JobRecord>& jobs,
                                       const WorkFolders& folders);

}  // namespace orbs::runner
