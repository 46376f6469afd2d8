#pragma once

#include "base/scratch_folder.h"
#include "run/plan/plan.h"
#include "studies/context.h"
#include "studies/cost/record.h"
#include "studies/cost/subject.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

namespace orbs::studies {

struct CostRequest {
  CostSettings settings;
  std::vector<int> rungs;        // samples per pixel of every rung; none: chosen by pilot renders
  std::filesystem::path folder;  // of the study; it exists
};

/// A study of cost while it goes on.
struct CostStudy {
  const run::Plan& plan;
  const CostRequest& request;
  const StudyContext& context;
  CostRecord record;
  std::vector<CostSubject> subjects;  // by target of the record
  ScratchFolder scratch{"orbs-cost"};
};

/// Makes the render that `wanted` names (target, renderer, purpose, rung, samples, seed), and fills in what
/// it cost and, unless it is of the fixed cost, its errors. `kept_rung`: the index of the rung as whose image
/// it is kept in the study's folder. Nothing when the user interrupts; InputError when there is no image.
std::optional<CostRender> measured_render(const CostStudy& study,
                                          CostRender wanted,
                                          std::optional<std::size_t> kept_rung = {});

}  // namespace orbs::studies
