#pragma once

#include "results/record.h"

#include <filesystem>
#include <string>
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

/// The text of a job's job.json (format "orbs-job/2"): the record of the render, and the records of the
/// targets whose image it makes alone.
std::string job_json(const JobRecord& job, const std::vector<TargetRecord>& targets);

/// The text that `orbs effects --json` prints (format "orbs-effects/1").
std::string scenes_json(const std::vector<SceneRecord>& scenes);

/// The text of results.json (format "orbs-results/2"): the whole record. The host of a render is left out if
/// it is the run's.
std::string run_json(const RunRecord& run);

}  // namespace orbs::results
