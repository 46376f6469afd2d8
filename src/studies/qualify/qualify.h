#pragma once

#include "results/qualification.h"
#include "results/record.h"
#include "run/plan/plan.h"
#include "studies/context.h"

#include <string>
#include <vector>

/// Mutation testing of the gates: do the gates of each case reject every mutant of a control image and accept
/// the control image itself, and how small is the smallest fault that they reject?
namespace orbs::studies {

struct QualifySettings {
  std::string renderer = "orbs";  // whose images in the run are the control images
  /// Share of the case's samples for the renders without one of the lights; few do, as a missing light is a
  /// large fault.
  double missing_light_spp_scale = 0.125;
};

/// One record for each image of the plan's cases, in their order. The control images are those of `run`,
/// whose folder must be there; their seed is another than that of the references. The plan's first renderer
/// renders the scenes without a light. Only whole records: fewer when the user interrupts.
std::vector<results::GateRecord> qualify(const run::Plan& plan,
                                         const results::RunRecord& run,
                                         const QualifySettings& settings,
                                         const StudyContext& context);

/// `known` with each record of `found` replacing the one of the same target.
std::vector<results::GateRecord> merged(std::vector<results::GateRecord> known,
                                        const std::vector<results::GateRecord>& found);

}  // namespace orbs::studies
