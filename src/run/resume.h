#pragma once

#include "judge/reference.h"
#include "results/record.h"
#include "run/execute.h"
#include "run/plan/plan.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

/// What a render and its verdicts depend on, as hashes: they tell whether it would come out the same today.
/// What is done with a job of which an earlier run may have left a render.

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

enum class Step { Keep, Judge, Render };

struct Resumption {
  Step step = Step::Render;
  std::string reason{};                     // why a render that is there is made again; "" where none is
  std::optional<results::JobFile> found{};  // what is kept or judged
};

/// Decides by what lies in the run's folder. `now` is the record of the job with the hashes of today and the
/// version of its renderer.
Resumption resumption_of(const Plan& plan,
                         std::size_t job,
                         const results::JobRecord& now,
                         const WorkFolders& folders);

/// The render that was found, in its own unfinished folder, to be judged by what has changed. Nothing
/// when its image is gone or cannot be read any more.
std::optional<Execution> take_over(const results::JobRecord& found,
                                   const std::filesystem::path& folder,
                                   const WorkFolders& folders);

}  // namespace orbs::run
