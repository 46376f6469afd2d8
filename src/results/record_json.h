#pragma once

#include "results/record.h"

#include <string>

namespace orbs::results {

/// The text of a job's job.json (format "orbs-job/1"): all of the record, and what was said about the
/// pictures that the render alone makes.
std::string job_json(const JobRecord& job, const std::vector<PictureRecord>& pictures);

/// The text of results.json (format "orbs-results/1"): all of the record. Infinite measures are written as
/// null with "infinite": true beside them, since JSON has no infinity.
std::string run_json(const RunRecord& run);

}  // namespace orbs::results
