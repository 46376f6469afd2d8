#pragma once

#include "results/record.h"
#include "runner/plan.h"

#include <optional>
#include <string>

/// Whether a render that is there would come out the same today.
namespace orbs::runner {

/// Of the scene's file with all that it names, as provenance records of references have it; where the
/// renderer has a hand-written scene, of both.
std::string scene_hash(const Plan& plan, const PlannedJob& job);

/// Of what else makes the image: program, command, environment, settings of the exporter, threads.
std::string settings_hash(const Plan& plan, const PlannedJob& job);

/// Of what may end a render without an image: time, memory, size of its files.
std::string limits_hash(const Plan& plan, const PlannedJob& job);

/// Of what the images of the render at `index` are judged by: cases, references, this version of orbs.
std::string judged_hash(const Plan& plan, std::size_t index, const std::string& orbs_version);

/// Fills the four into the record.
void note_hashes(const Plan& plan,
                 std::size_t index,
                 const std::string& orbs_version,
                 results::JobRecord& record);

/// Why a render that is there must be rendered again: "its scene has changed"; nothing when it need not.
/// `now` is its record with the hashes and the renderer's version of today.
std::optional<std::string> why_outdated(const results::JobRecord& found, const results::JobRecord& now);

}  // namespace orbs::runner
