#pragma once

#include "json/writer.h"
#include "results/record.h"

#include <string>
#include <vector>

namespace orbs::results {

/// One number as an object. Infinite ones are written as null with "infinite": true beside them, since JSON
/// has no infinity.
void write_measure(json::Writer& out, const Measure& measure);

/// All that is known of the machine, as an object.
void write_host(json::Writer& out, const Host& host);
void write_scene(json::Writer& out, const SceneRecord& scene);

/// The text of a job's job.json (format "orbs-job/1"): all of the record, and what was said about the
/// images that the render alone makes.
std::string job_json(const JobRecord& job, const std::vector<TargetRecord>& targets);

/// What `orbs plan --json` prints (format "orbs-plan/1").
std::string scenes_json(const std::vector<SceneRecord>& scenes);

/// The text of results.json (format "orbs-results/1"): all of the record. The host of a render is left out
/// where it is the run's.
std::string run_json(const RunRecord& run);

}  // namespace orbs::results
