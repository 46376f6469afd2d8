#pragma once

#include "results/record.h"

#include <string>
#include <vector>

namespace orbs::results {

/// The text of a job's job.json (format "orbs-job/2"): the record of the render, and the records of the
/// targets whose image it makes alone.
std::string job_json(const JobRecord& job, const std::vector<TargetRecord>& targets);

/// The text that `orbs effects --json` prints (format "orbs-effects/1").
std::string scenes_json(const std::vector<SceneRecord>& scenes);

/// The text of results.json (format "orbs-results/2"): the whole record. The host of a render is left out if
/// it is the run's.
std::string run_json(const RunRecord& run);

}  // namespace orbs::results
