#pragma once

#include "adapters/job.h"
#include "run/plan/plan.h"
#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

/// From a planned job to what its renderer is given.
namespace orbs::run {

/// The entry of the job's renderer with the exporter's settings that it has for the job's scene.
registry::Renderer entry_for(const Plan& plan, const PlannedJob& job);

/// The limits of the job's renderer, with the shorter of its time limit and that of the scene's case.
ProcessLimits limits_of(const Plan& plan, const PlannedJob& job);

/// Likewise, for a case that allows `case_seconds`; 0 where it has no limit.
ProcessLimits limits_of(const registry::Renderer& renderer, double case_seconds);

/// The scene in the form that the job's renderer reads: lowered to its format, or unchanged where a
/// hand-written scene exists for it. Else the reason why the renderer cannot render it.
std::variant<scene::Scene, std::string> scene_for(const Plan& plan, const PlannedJob& job);

/// Writes the scene of a job, as scene_for gave it, into the folder of `job`, which must exist: exported, or
/// copied from where it was written by hand. Where the renderer is elsewhere, files that the scene names are
/// copied beside it.
void write_job_scene(const Plan& plan,
                     const PlannedJob& planned,
                     const scene::Scene& prepared,
                     const adapters::Job& job);

/// The arguments that the case of the job's scene has for its renderer; none mostly.
std::vector<std::string> scene_arguments(const Plan& plan, const PlannedJob& job);

/// The job in `folder`, once for each seed that the renderer is given (seed replicas): the seeds count up
/// from that of the settings, and the replicas share their samples. At least one.
std::vector<adapters::Job> replicas_of(const registry::Renderer& renderer,
                                       const scene::Scene& scene,
                                       const adapters::JobSettings& settings,
                                       const std::filesystem::path& folder);

/// One render of a job of the plan, in the job's own folder, with other samples than planned.
adapters::Job one_render(const Plan& plan,
                         const PlannedJob& job,
                         const std::filesystem::path& folder,
                         int spp,
                         const std::string& image_file);

/// The same for a job of the plan, with all paths below `run_folder`; for one with a look those of its two
/// renders.
std::vector<adapters::Job> replicas_of(const Plan& plan,
                                       const PlannedJob& job,
                                       const std::filesystem::path& run_folder);

}  // namespace orbs::run
