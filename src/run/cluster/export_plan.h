#pragma once

#include "registry/configuration.h"
#include "registry/run_settings.h"
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
/// samples, seed and size; RENDERER in its environment is the program. export.json says what orbs judge has
/// to know.
ExportedPlan export_plan(const Plan& plan,
                         const std::filesystem::path& configuration,
                         const std::filesystem::path& folder);

/// What export.json (format "orbs-export/1") says.
struct ExportFile {
  std::filesystem::path configuration;
  registry::RunSettings settings;
};

/// InputError if the folder holds none, or it is broken.
ExportFile read_export_file(const std::filesystem::path& folder);

}  // namespace orbs::run
