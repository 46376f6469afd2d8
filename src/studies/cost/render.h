#pragma once

#include "base/files.h"
#include "image/image.h"
#include "metrics/mask.h"
#include "registry/case.h"
#include "run/machine_time.h"
#include "run/plan/plan.h"
#include "studies/context.h"
#include "studies/cost/record.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

namespace orbs::studies {

/// A scene that a study of cost renders, and what it is measured against. Points into the plan.
struct CostSubject {
  CostTarget target;
  const registry::Case* one_case = nullptr;
  const run::PlannedScene* scene = nullptr;
  image::Image reference;
  metrics::Mask mask;
};

/// The scenes that some renderer of the plan renders, each once. Copies their references, at the size of the
/// plan, to images/reference in `folder`. InputError when a reference is missing or there is no scene.
std::vector<CostSubject> load_cost_subjects(const run::Plan& plan, const std::filesystem::path& folder);

struct CostRequest {
  CostSettings settings;
  std::vector<int> samples;      // per pixel, of every sweep by samples; none: chosen by pilot renders
  std::filesystem::path folder;  // of the study; it exists
  /// The time of all processors; tests make it up.
  std::function<std::optional<run::MachineTime>()> machine_time = [] { return run::machine_time(); };
};

/// A study of cost while it goes on.
struct CostMeasurement {
  const run::Plan& plan;
  const CostRequest& request;
  const StudyContext& context;
  CostRecord record;
  std::vector<CostSubject> subjects;  // by target of the record
  ScratchFolder scratch{"orbs-cost"};
};

/// Makes the render that `wanted` names (target, renderer, purpose, setting, samples, seed), and fills in
/// what it cost and, unless it is of the fixed cost, its errors. `kept_as`: the index of the setting as whose
/// image it is kept in the study's folder. Nothing when the user interrupts; InputError when there is no
/// image.
std::optional<CostRender> measured_render(const CostMeasurement& study,
                                          CostRender wanted,
                                          std::optional<std::size_t> kept_as = {});

}  // namespace orbs::studies
