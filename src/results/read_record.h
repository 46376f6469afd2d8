#pragma once

#include "results/record.h"

#include <filesystem>
#include <vector>

namespace orbs::results {

/// The contents of a job.json: the render, and the targets whose image it makes alone.
struct JobFile {
  JobRecord job;
  std::vector<TargetRecord> targets;
};

/// Reads a job.json. InputError with file, line and key. Unknown members are ignored, since a newer program
/// may have written them; a missing member keeps its default unless it is required.
JobFile read_job_file(const std::filesystem::path& file);

/// Reads a results.json in the same way. `folder` of the record is the one that the file lies in now, not the
/// one that it was written to.
RunRecord read_results_file(const std::filesystem::path& file);

}  // namespace orbs::results
