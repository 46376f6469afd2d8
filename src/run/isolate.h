#pragma once

#include "adapters/job.h"
#include "adapters/process/isolation.h"
#include "run/plan/plan.h"

#include <filesystem>
#include <string>
#include <vector>

/// What renderers see under --sandbox: their programs, the files that their commands and scenes name, and
/// their own folder.
namespace orbs::run {

/// For renders of a scene in `folder` by these command lines. The renderer sees no reference, case or
/// repository of version control, and no run beside the one in `run_folder`, since these hold copies of
/// references.
adapters::Isolation isolation_of(const Plan& plan,
                                 const ChosenRenderer& renderer,
                                 const scene::Scene& scene,
                                 const std::vector<adapters::Job>& jobs,
                                 const std::filesystem::path& run_folder);

/// For its version command, in an empty folder.
adapters::Isolation isolation_of_version(const Plan& plan,
                                         const ChosenRenderer& renderer,
                                         const std::vector<std::string>& argv,
                                         const std::filesystem::path& folder);

/// The files that a scene names beside its own: textures and measured lights.
std::vector<std::filesystem::path> files_of(const scene::Scene& scene);

}  // namespace orbs::run
