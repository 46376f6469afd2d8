#pragma once

#include "results/job_record.h"
#include "run/plan/plan.h"
#include "run/render.h"

#include <atomic>
#include <filesystem>

/// What rounding decides in the scene of a job: its condition. A renderer whose entry names double_precision
/// renders it twice with the same random numbers, the second time in double precision.
namespace orbs::run {

/// Samples per pixel of either render, or fewer where the job has fewer. The mean difference of single pixels
/// hardly depends on them: a path that takes another way moves its pixel by 1/n, and n times as many do.
constexpr int kConditionSpp = 16;

/// The two images in the folder of the job.
inline constexpr const char* kSinglePrecisionImage = "single-precision.exr";
inline constexpr const char* kDoublePrecisionImage = "double-precision.exr";

/// Sets PlannedJob::has_condition of all jobs: where a case that judges the scene bounds its condition map,
/// the renderer can work in double precision, and it is here.
void plan_conditions(Plan& plan);

/// Makes both renders in the folder of `job`, which holds the scene, within its limits and its sandbox, and
/// leaves their images there. Their times are added to `cost`.
results::JobCondition measure_condition(const Plan& plan,
                                        const PlannedJob& planned,
                                        const RenderJob& job,
                                        const std::atomic<bool>* stop,
                                        results::JobCost& cost);

/// Copies both images from the folder of an earlier look to that of the next one; where a renderer has
/// removed them, there are none.
void keep_condition_images(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace orbs::run
