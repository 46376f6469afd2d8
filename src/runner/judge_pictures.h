#pragma once

#include "results/record.h"
#include "runner/execute.h"
#include "runner/judge.h"
#include "runner/plan.h"

#include <filesystem>
#include <optional>
#include <vector>

/// From renders to records of pictures.
namespace orbs::runner {

/// Where a run keeps its copies of the references.
inline constexpr const char* kReferenceFolder = "references";

/// The record of a picture that nothing is known about yet. `folder` is the run's.
results::PictureRecord blank_picture(const Plan& plan,
                                     const PlannedPicture& planned,
                                     const std::filesystem::path& folder);

/// Of a picture that is not rendered because its renderer does not declare the requirement.
results::PictureRecord undeclared_picture(const Plan& plan,
                                          const PlannedPicture& planned,
                                          const std::filesystem::path& folder);

/// What is said about a picture with usable pixels: negative values, the gate and all conditions of the case,
/// and whether it is of one colour. Returns the comparison, for its maps; nothing when there was none.
std::optional<metrics::Comparison> judge_values(const registry::Case& one_case,
                                                const image::Image& result,
                                                const Reference& reference,
                                                const JudgeSettings& settings,
                                                results::PictureRecord& record);

/// What became of the render is what there is to say about its picture.
void take_job_verdict(const results::JobRecord& job, results::PictureRecord& record);

/// All pictures that this render alone makes, one for each case that looks at it; their maps lie in its
/// unfinished folder.
std::vector<results::PictureRecord> judge_scene(const Plan& plan,
                                                std::size_t job,
                                                const Execution& execution,
                                                const WorkFolders& folders);

/// A difference of two renders that are in their places; its folder takes its own.
results::PictureRecord judge_difference(const Plan& plan,
                                        const PlannedPicture& planned,
                                        const std::vector<results::JobRecord>& jobs,
                                        const WorkFolders& folders);

}  // namespace orbs::runner
