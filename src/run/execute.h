#pragma once

#include "image/image.h"
#include "judge/reference.h"
#include "metrics/merged_renders.h"
#include "results/record.h"
#include "run/plan/plan.h"

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace orbs::run {

/// Each job renders into `unfinished` and is renamed into `run` when complete; below both it has its own
/// folder.
struct WorkFolders {
  std::filesystem::path run;
  std::filesystem::path unfinished;
  judge::ReferenceCopies references{};  // by which the images are judged
};

struct Execution {
  results::JobRecord record;
  std::optional<image::Image> image;
  std::vector<image::Image> renders{};                // of the look, where the job has one
  std::optional<metrics::MergedRenders> merged = {};  // of all looks; `image` is its mean
};

/// Prepares the scene, runs the renderer once for each seed replica and classifies the outcome. Touches only
/// the job's unfinished folder, which it makes. InputError when the scene cannot be written for its renderer,
/// WriteError when the disk refuses.
Execution execute(const Plan& plan,
                  const PlannedJob& planned,
                  const std::string& version,
                  const WorkFolders& folders,
                  const std::atomic<bool>* stop);

/// The record of a job that has not been run.
results::JobRecord skipped_record(const Plan& plan, const PlannedJob& job);

}  // namespace orbs::run
