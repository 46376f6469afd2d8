#pragma once

#include "run/plan/plan.h"
#include "studies/context.h"
#include "studies/stability/images.h"
#include "studies/stability/record.h"

#include <filesystem>
#include <vector>

/// How long the numbers of a scene may become hard before a renderer's image is no longer what a relation
/// demands.
namespace orbs::studies {

struct StabilityRequest {
  StabilitySettings settings;
  std::vector<StabilityRelation> relations;
  std::filesystem::path folder;  // of the study; it exists
};

/// Renders each scene of the plan and its changed forms with each renderer, in pairs of the same seed. A
/// sweep ends after two steps in a row that break. Writes the record into the folder as it goes on, scene
/// files of steps that break, and images of the first. `record` holds what an interrupted study of the same
/// plan had measured: no step is made twice. is_finished is false when the user interrupts.
StabilityRecord measure_stability(const run::Plan& plan,
                                  const StabilityRequest& request,
                                  StabilityRecord record,
                                  const StudyContext& context);

}  // namespace orbs::studies
