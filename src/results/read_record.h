#pragma once

#include "results/record.h"

#include <filesystem>
#include <vector>

namespace orbs::results {

/// What job.json holds: the render, and what was said about the images that it alone makes.
struct JobFile {
  JobRecord job;
  std::vector<TargetRecord> targets;
};

/// Reads a job.json. InputError with file, line and key. Members that this program does not know are left
/// out, since a newer one may have written them; a member that is missing has its default.
JobFile read_job_file(const std::filesystem::path& file);

/// Reads a results.json in the same way. `folder` of the record is the one that the file lies in now, not the
/// one that it was written to.
RunRecord read_results_file(const std::filesystem::path& file);

}  // namespace orbs::results
