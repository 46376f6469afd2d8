#pragma once

#include "results/record.h"

#include <string>

namespace orbs::results {

/// The text of a job's job.json (format "orbs-job/1"): all of the record.
std::string job_json(const JobRecord& job);

/// The text of results.json (format "orbs-results/1"): all of the record. Infinite measures are written as
/// null with "infinite": true beside them, since JSON has no infinity.
std::string run_json(const RunRecord& run);

}  // namespace orbs::results
