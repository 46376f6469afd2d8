#pragma once

#include "judge/reference.h"
#include "results/record.h"
#include "run/plan/plan.h"

#include <filesystem>
#include <optional>
#include <string>

/// What a render and its verdicts depend on, as hashes: they tell whether it would come out the same today.
namespace orbs::run {

/// Hash of the scene file with all files that it names, as provenance records of references have it; where
/// the renderer has a hand-written scene, of both.
std::string scene_hash(const Plan& plan, const PlannedJob& job);

/// Hash of what else makes the image: program, command, environment, settings of the exporter, threads.
std::string settings_hash(const Plan& plan, const PlannedJob& job);

/// Hash of what may end a render without an image: time, memory, size of its files.
std::string limits_hash(const Plan& plan, const PlannedJob& job);

/// Hash of what the images of the job at `index` are judged by: cases, references as they were copied, this
/// version of orbs.
std::string judged_hash(const Plan& plan,
                        std::size_t index,
                        const judge::ReferenceCopies& references,
                        const std::string& orbs_version);

/// Hash of the scene file and of the image of a complete render whose folder is below `run_folder`; a file
/// that is not there counts as empty.
std::string files_hash(const Plan& plan,
                       const PlannedJob& job,
                       const results::JobRecord& record,
                       const std::filesystem::path& run_folder);

}  // namespace orbs::run
