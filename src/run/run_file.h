#pragma once

#include "registry/run_settings.h"
#include "registry/shard.h"

#include <filesystem>
#include <string>

namespace orbs::run {

/// The request of a run, stored in its folder as run.json (format "orbs-run/1"): all that --resume needs.
struct RunFile {
  std::filesystem::path configuration;  // absolute
  registry::RunSettings settings;       // after the command line
  std::string started;                  // local time, ISO 8601
  registry::Shard shard{};              // the part of the renders that this run does
};

/// Makes the folder of a run, or of a study: `wanted`, which must not exist or be empty, or "" for
/// <kind>-YYMMDD-HHMMSS (local time) in the current folder, with -2, -3, ... behind it where that is taken.
/// Returns the absolute path.
std::filesystem::path make_run_folder(const std::string& wanted, const std::string& kind = "outputs");

/// InputError when the folder is not that of a run, or its run.json is broken.
RunFile read_run_file(const std::filesystem::path& folder);

void write_run_file(const RunFile& file, const std::filesystem::path& folder);

}  // namespace orbs::run
