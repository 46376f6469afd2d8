#pragma once

#include "image/image.h"
#include "metrics/mask.h"
#include "registry/case.h"
#include "run/plan/plan.h"
#include "studies/cost/record.h"

#include <filesystem>
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

}  // namespace orbs::studies
