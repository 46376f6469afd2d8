#pragma once

#include "registry/run_settings.h"
#include "run/run_file.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace orbs::cli {

/// What failed in an earlier run.
struct LastFailed {
  std::filesystem::path run;
  std::vector<run::OnlyTarget> targets;  // none: nothing failed
};

/// Of the newest run of the settings' suite and size, with one of their renderers, among the folders beside
/// the folder that the settings name for a new one. Known failures did not fail. InputError if there is no
/// such run.
LastFailed last_failed(const registry::RunSettings& settings);

}  // namespace orbs::cli
