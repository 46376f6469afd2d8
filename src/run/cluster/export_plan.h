#pragma once

#include "run/plan/plan.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

/// Scenes for a renderer that is somewhere else, and the images that come back.
namespace orbs::run {

struct ExportedPlan {
  std::size_t renders = 0;
  std::vector<std::string> left_out;  // "mitsuba 124: why"
};

/// Writes into the new folder `folder` what the jobs of the plan need, each in <renderer>/<scene>/: the scene
/// with all its files, no path of which leads out of its folder. render.sh has the command of each job with
/// samples, seed and size; RENDERER in its environment is the program. export.json lists the images.
ExportedPlan export_plan(const Plan& plan, const std::filesystem::path& folder);

}  // namespace orbs::run
