#pragma once

#include "base/scratch_folder.h"
#include "image/image.h"
#include "metrics/mask.h"
#include "registry/case.h"
#include "run/plan/plan.h"
#include "studies/context.h"
#include "studies/cost/record.h"
#include "studies/cost/study.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

/// The parts of measure_cost, for the files of this folder.
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

/// Renders a pilot of every scene by every renderer that renders it, and chooses the sweeps of a study of
/// `budget_seconds` of wall clock, the pilots included, unless the request gives them. A renderer that fails
/// on a scene gets a sweep without settings, with the reason in its note. False when the user interrupts.
bool find_sweeps(CostMeasurement& study, double budget_seconds);

}  // namespace orbs::studies
