#pragma once

#include "image/image.h"
#include "judge/reference.h"
#include "registry/cases.h"
#include "results/qualification.h"
#include "studies/qualify/images.h"

#include <map>
#include <string>
#include <vector>

namespace orbs::studies {

/// All that the gates of one target are tested with.
struct MutationSubject {
  const registry::Case& one_case;
  std::string target;
  judge::Reference reference;  // without an image where pixel checks alone judge the target
  image::Image control;
  const std::map<std::string, image::Image>& others;  // references of the suite, by name
  const std::vector<RenderedMutant>& rendered_mutants;
  std::string why_no_light_can_miss;  // "" when lights are missing in some of them
};

/// Mutation test of the gates of one target: judges the control image and all mutants, and searches for the
/// smallest faults that are rejected. Judged exactly as the images of a run are. Fills all of the record but
/// control, judged_by and provenance.
results::GateRecord mutation_test(const MutationSubject& subject);

}  // namespace orbs::studies
