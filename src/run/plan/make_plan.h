#pragma once

#include "registry/configuration.h"
#include "run/plan/plan.h"

#include <filesystem>

namespace orbs::run {

/// Reads everything that the settings choose. `program_folder` is the folder of the orbs program. InputError
/// for all that is wrong: files, filters that choose nothing, a gate of an unknown metric, a renderer that is
/// named but not installed, an executable that cannot be executed. Nothing need be installed for renderers
/// that are elsewhere.
Plan make_plan(const registry::Configuration& configuration,
               const registry::RunSettings& settings,
               const std::filesystem::path& program_folder,
               RenderPlace place = RenderPlace::Here);

}  // namespace orbs::run
